/**
 * Noise that depends on a seed and on the requested time, never on the number of requests.
 *
 * <p>{@link org.dfra.sim.world.noise.RandomStream} gives the n-th number of a stream without the
 * ones before it, and each name its own substream. White noise is the random number of its time
 * step; noise with a memory ({@link org.dfra.sim.world.noise.CorrelatedNoise}) computes each step
 * with that step's random number. All arithmetic is that of the Java language and {@code
 * StrictMath}, so results are the same on every machine.
 */
@NullMarked
package org.dfra.sim.world.noise;

import org.jspecify.annotations.NullMarked;
