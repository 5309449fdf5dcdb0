/**
 * Perceptual schemas, one package each: they compute percepts from sensor readings, independently
 * of their use.
 */
@NullMarked
package org.dfra.behaviors.perceptual;

import org.jspecify.annotations.NullMarked;
