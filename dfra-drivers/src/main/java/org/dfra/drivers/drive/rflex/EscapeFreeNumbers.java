package org.dfra.drivers.drive.rflex;

/**
 * Numbers of four bytes none of which is 1B. The controller takes 1B for the beginning of an end
 * wherever it stands, and knows no way to say that it is not meant so.
 */
final class EscapeFreeNumbers {

  static final long MOST = 0xFFFF_FFFFL;

  private EscapeFreeNumbers() {}

  /**
   * The nearest such number; of two equally near the smaller.
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

  /** The place of the first byte that is 1B, in bits from the right; negative where none is. */
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
