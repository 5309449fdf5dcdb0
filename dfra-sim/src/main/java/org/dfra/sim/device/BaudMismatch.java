package org.dfra.sim.device;

import java.io.ByteArrayOutputStream;

/**
 * Simulates a receiver with another baud rate than the sender's, bit by bit, 8N1: it waits for a
 * falling edge and samples in the middle of what it assumes to be each bit. Pure.
 */
final class BaudMismatch {

  private static final int BITS = 10;

  private BaudMismatch() {}

  /**
   * The bytes that the receiver reads.
   *
   * @param sent bytes on a line that was idle before and is idle after; without gaps
   * @param sentBaud bits per second of the sender
   * @param readBaud bits per second of the receiver
   */
  static byte[] of(byte[] sent, int sentBaud, int readBaud) {
    if (sentBaud == readBaud) {
      return sent;
    }
    ByteArrayOutputStream read = new ByteArrayOutputStream();
    double step = (double) sentBaud / readBaud; // sent bits in a bit that is read
    int end = sent.length * BITS;
    int fall = nextFall(sent, 0);
    while (fall < end) {
      int value = 0;
      for (int bit = 0; bit < 8; bit++) {
        value |= level(sent, fall + (1.5 + bit) * step) << bit;
      }
      if (level(sent, fall + 0.5 * step) == 0) { // else it was a spike, not a start bit
        read.write(value);
      }
      fall = nextFall(sent, (int) Math.ceil(fall + 9.5 * step));
    }
    return read.toByteArray();
  }

  /** The first bit from here on that is low after a high one. */
  private static int nextFall(byte[] sent, int from) {
    int end = sent.length * BITS;
    int at = from;
    while (at < end && (level(sent, at) != 0 || (at > 0 && level(sent, at - 1) == 0))) {
      at++;
    }
    return at;
  }

  /** The line at a time, in sent bits; idle is high. */
  private static int level(byte[] sent, double time) {
    int bit = (int) Math.floor(time);
    if (bit < 0 || bit >= sent.length * BITS) {
      return 1;
    }
    int place = bit % BITS;
    return place == 0 ? 0 : place == BITS - 1 ? 1 : sent[bit / BITS] >> (place - 1) & 1;
  }
}
