/**
 * Noise that depends on a seed and on the time it is asked for, never on how often it is asked.
 *
 * <p>{@link org.dfra.sim.world.noise.RandomStream} gives the n-th number of a stream without the
 * ones before it, and a stream of its own to each name. White noise is the draw of its time step;
 * noise with a memory ({@link org.dfra.sim.world.noise.CorrelatedNoise}) takes each step with that
 * step's draw, whenever it gets there. All arithmetic is that of the Java language and {@code
 * StrictMath}, so the same on every machine.
 */
@NullMarked
package org.dfra.sim.world.noise;

import org.jspecify.annotations.NullMarked;
