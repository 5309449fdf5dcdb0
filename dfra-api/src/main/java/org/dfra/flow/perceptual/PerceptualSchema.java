package org.dfra.flow.perceptual;

import org.dfra.flow.Schema;

/** A module that makes percepts of what sensors, or other perceptual schemas, tell. */
public interface PerceptualSchema extends Schema {}
