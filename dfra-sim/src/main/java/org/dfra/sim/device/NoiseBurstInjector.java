package org.dfra.sim.device;

import java.nio.ByteBuffer;
import java.util.Random;

/**
 * Noise between what a device says, as on a line that floats now and then. What it says itself is
 * left as it is. The same for the same pieces and seed; confined to one thread.
 */
final class NoiseBurstInjector {

  private static final int LONGEST = 2000;

  /** Of so many pieces, one has noise before it. */
  private static final int ONE_OF = 3;

  private final Random random;

  NoiseBurstInjector(long seed) {
    this.random = new Random(seed);
  }

  /** A piece with what comes before it. */
  byte[] withNoise(byte[] piece) {
    if (piece.length == 0 || random.nextInt(ONE_OF) != 0) {
      return piece;
    }
    byte[] noise = new byte[random.nextInt(LONGEST)];
    random.nextBytes(noise);
    return ByteBuffer.allocate(noise.length + piece.length).put(noise).put(piece).array();
  }
}
