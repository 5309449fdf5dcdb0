package org.dfra.behavior;

import java.io.Serializable;

/** What a {@link Behavior} shall achieve. Immutable. */
public interface Goal extends Serializable {}
