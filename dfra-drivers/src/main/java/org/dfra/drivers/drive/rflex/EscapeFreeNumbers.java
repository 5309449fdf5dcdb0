package org.dfra.drivers.drive.rflex;

/**
 * Four-byte numbers without the byte 1B. The controller treats every 1B as the beginning of an end
 * mark, and its protocol has no escape sequence.
 */
final class EscapeFreeNumbers {

  static final long MOST = 0xFFFF_FFFFL;

  private EscapeFreeNumbers() {}

  /**
   * The nearest such number; the smaller of two equally near ones.
   *
   * @param value 0 to {@link #MOST}
   */
  static long nearest(long value) {
    long below = atMost(value);
    long above = atLeast(value);
    return value - below <= above - value ? below : above;
  }

  /**
   * The greatest such number that is not greater.
   *
   * @param value 0 to {@link #MOST}
   */
  static long atMost(long value) {
    int shift = escapeIn(value);
    return shift < 0 ? value : (value >>> shift << shift) - 1; // ends in 1A FF.., all free
  }

  /**
   * The smallest such number that is not smaller.
   *
   * @param value 0 to {@link #MOST}
   */
  static long atLeast(long value) {
    int shift = escapeIn(value);
    return shift < 0 ? value : (value >>> shift << shift) + (1L << shift); // ends in 1C 00..
  }

  /** Position of the first byte that is 1B, in bits from the right; negative if there is none. */
  private static int escapeIn(long value) {
    if (value < 0 || value > MOST) {
      throw new IllegalArgumentException(value + " is outside 0 to " + MOST);
    }
    int shift = 24;
    while (shift >= 0 && (value >>> shift & 0xFF) != RflexFramer.ESCAPE) {
      shift -= 8;
    }
    return shift;
  }
}
