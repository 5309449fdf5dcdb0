package org.dfra.drivers.gps.m12;

/**
 * What the receiver knows of UTC.
 *
 * @param isUtc whether it tells UTC; otherwise GPS time
 * @param isKnown whether it has learned the offset from the satellites; after a cold start that
 *     takes up to 12.5 minutes
 * @param offset GPS time minus UTC, seconds, −32 to 31
 */
public record UtcState(boolean isUtc, boolean isKnown, int offset) {

  static UtcState of(int bits) {
    return new UtcState((bits & 0x80) != 0, (bits & 0x40) != 0, (bits & 0x3F) << 26 >> 26);
  }
}
