package org.dfra.drivers.laser.lms;

/** The CRC of a telegram: SICK's own 16 bits, over all bytes before it. */
final class LmsCrc {

  private static final int POLYNOMIAL = 0x8005;

  private LmsCrc() {}

  /** The CRC of {@code bytes[from]} to {@code bytes[to - 1]}, 0 to FFFF hex. */
  static int of(byte[] bytes, int from, int to) {
    int crc = 0;
    int last = 0;
    for (int i = from; i < to; i++) {
      int next = bytes[i] & 0xFF;
      crc = (crc & 0x8000) == 0 ? crc << 1 : (crc << 1 & 0xFFFF) ^ POLYNOMIAL;
      crc ^= last << 8 | next;
      last = next;
    }
    return crc;
  }
}
