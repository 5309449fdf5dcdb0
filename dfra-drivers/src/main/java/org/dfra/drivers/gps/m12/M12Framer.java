package org.dfra.drivers.gps.m12;

import org.dfra.drivers.frame.FrameScanner;

/** Finds the frames of Motorola's binary protocol. */
public final class M12Framer extends FrameScanner {

  private static final int HEAD = 4;
  private static final int TAIL = 3;

  /** A framer at the beginning of a stream. */
  public M12Framer() {
    super(M12Lengths.LONGEST);
  }

  @Override
  protected int frameLengthAt(byte[] bytes, int at, int end) {
    int there = end - at;
    if (bytes[at] != '@' || (there > 1 && bytes[at + 1] != '@')) {
      return NONE;
    }
    if (there > 2 && (bytes[at + 2] < 'A' || bytes[at + 2] > 'Z')) {
      return NONE;
    }
    if (there < HEAD) {
      return NEEDS_MORE;
    }
    int length = M12Lengths.of(bytes[at + 2], bytes[at + 3]);
    if (length > there) {
      return NEEDS_MORE;
    }
    return length > 0 && isIntact(bytes, at, length) ? length : NONE;
  }

  private static boolean isIntact(byte[] bytes, int at, int length) {
    int checksumAt = at + length - TAIL;
    return bytes[checksumAt + 1] == '\r'
        && bytes[checksumAt + 2] == '\n'
        && bytes[checksumAt] == M12Commands.checksum(bytes, at + 2, checksumAt);
  }
}
