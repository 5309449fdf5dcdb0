package org.dfra.flow.perceptual;

import org.dfra.flow.Schema;

/** A module that computes percepts from the readings of sensors or other perceptual schemas. */
public interface PerceptualSchema extends Schema {}
