package org.dfra.drivers.gyro.kvh;

import org.dfra.drivers.frame.FrameScanner;

/**
 * Finds complete lines: from the line feed of the previous line to the carriage return, with only
 * characters of numbers. There is no checksum; the required line feed before each line prevents the
 * remainder of a truncated line from being read as a smaller number.
 */
public final class Dsp3000Framer extends FrameScanner {

  /** Longest line, its line feed included. */
  public static final int LONGEST = 40;

  /** A framer at the beginning of a stream. */
  public Dsp3000Framer() {
    super(LONGEST);
  }

  @Override
  protected int frameLengthAt(byte[] bytes, int at, int end) {
    if (bytes[at] != '\n') {
      return NONE;
    }
    int limit = Math.min(end, at + LONGEST);
    for (int i = at + 1; i < limit; i++) {
      byte next = bytes[i];
      if (next == '\r') {
        return i == at + 1 ? NONE : i + 1 - at;
      }
      boolean isDigit = next >= '0' && next <= '9';
      if (!isDigit && next != ' ' && next != '.' && next != '-' && next != '+') {
        return NONE;
      }
    }
    return end - at < LONGEST ? NEEDS_MORE : NONE;
  }
}
