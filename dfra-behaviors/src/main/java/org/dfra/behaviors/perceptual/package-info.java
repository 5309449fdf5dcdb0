/**
 * Perceptual schemas, a room each: what a robot makes of what its sensors tell. None of them knows
 * what is done with it.
 */
@NullMarked
package org.dfra.behaviors.perceptual;

import org.jspecify.annotations.NullMarked;
