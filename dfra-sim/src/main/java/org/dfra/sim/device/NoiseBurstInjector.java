package org.dfra.sim.device;

import java.nio.ByteBuffer;
import java.util.Random;

/**
 * Inserts noise bursts between a device's output, as a serial line that floats at times. The output
 * itself is unchanged. Reproducible for the same chunks and seed; confined to one thread.
 */
final class NoiseBurstInjector {

  private static final int LONGEST = 2000;

  /** One in this many chunks is preceded by noise. */
  private static final int ONE_OF = 3;

  private final Random random;

  NoiseBurstInjector(long seed) {
    this.random = new Random(seed);
  }

  /** A chunk, preceded by its noise burst if it has one. */
  byte[] withNoise(byte[] piece) {
    if (piece.length == 0 || random.nextInt(ONE_OF) != 0) {
      return piece;
    }
    byte[] noise = new byte[random.nextInt(LONGEST)];
    random.nextBytes(noise);
    return ByteBuffer.allocate(noise.length + piece.length).put(noise).put(piece).array();
  }
}
