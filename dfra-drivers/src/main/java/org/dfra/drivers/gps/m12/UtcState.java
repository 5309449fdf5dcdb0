package org.dfra.drivers.gps.m12;

/**
 * The receiver's knowledge of UTC.
 *
 * @param isUtc whether it reports UTC; otherwise GPS time
 * @param isKnown whether it has received the offset from the satellites; takes up to 12.5 minutes
 *     after a cold start
 * @param offset GPS time minus UTC, seconds, −32 to 31
 */
public record UtcState(boolean isUtc, boolean isKnown, int offset) {

  static UtcState of(int bits) {
    return new UtcState((bits & 0x80) != 0, (bits & 0x40) != 0, (bits & 0x3F) << 26 >> 26);
  }
}
