package org.dfra.sim.device;

import java.nio.ByteBuffer;
import java.util.Random;

/** Corrupts bytes as a bad contact does; reproducible by its seed. Confined to one thread. */
final class ByteCorrupter {

  private final Random random;
  private final double share;

  /**
   * @param share of the bytes that are damaged, 0 to 1
   */
  ByteCorrupter(long seed, double share) {
    if (!(share >= 0 && share <= 1)) {
      throw new IllegalArgumentException("share " + share + " is outside 0 to 1");
    }
    this.random = new Random(seed);
    this.share = share;
  }

  /** The bytes after corruption, at most twice as many. */
  byte[] corrupt(byte[] bytes) {
    ByteBuffer out = ByteBuffer.allocate(2 * bytes.length);
    for (byte each : bytes) {
      if (random.nextDouble() >= share) {
        out.put(each);
        continue;
      }
      switch (random.nextInt(3)) {
        case 0 -> out.put((byte) random.nextInt()); // bits were misread
        case 1 -> out.put((byte) random.nextInt()).put(each); // a spike was read as a byte
        default -> {} // its start bit was missed
      }
    }
    byte[] garbled = new byte[out.position()];
    out.flip().get(garbled);
    return garbled;
  }
}
