package org.dfra.flow.effector;

import java.io.Serializable;

/**
 * Something an effector is told to do. Immutable. The commands of a kind of effector are a sealed
 * interface of records.
 */
public interface Command extends Serializable {}
