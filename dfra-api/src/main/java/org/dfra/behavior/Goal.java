package org.dfra.behavior;

import java.io.Serializable;

/** What a {@link Behavior} is to reach. Immutable. */
public interface Goal extends Serializable {}
