package org.dfra.flow.effector;

import java.io.Serializable;

/**
 * A command to an effector. Immutable. The commands of a kind of effector are a sealed interface of
 * records.
 */
public interface Command extends Serializable {}
