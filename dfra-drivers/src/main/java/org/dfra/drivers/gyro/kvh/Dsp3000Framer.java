package org.dfra.drivers.gyro.kvh;

import org.dfra.drivers.frame.FrameScanner;

/**
 * Finds lines that are whole: from the line feed of the one before to the carriage return, made of
 * nothing but what numbers are made of. There is no checksum; that each line begins with the end of
 * another keeps the rest of a cut one from being taken for a smaller number.
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
