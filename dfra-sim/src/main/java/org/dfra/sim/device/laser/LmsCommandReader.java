package org.dfra.sim.device.laser;

import java.util.Arrays;

/** Parses telegrams to the laser from the bytes that a computer sends. Confined to one thread. */
final class LmsCommandReader {

  /** Receives parsed telegrams. */
  interface Sink {

    /** An intact telegram's payload. */
    void command(byte[] payload);

    /** A damaged telegram. */
    void damaged();
  }

  private static final int HEAD = 4;
  private static final int TAIL = 2;
  private static final int LONGEST = HEAD + 64 + TAIL;

  private final Sink sink;
  private final byte[] window = new byte[LONGEST];
  private int filled;

  LmsCommandReader(Sink sink) {
    this.sink = sink;
  }

  void feed(byte[] bytes, int offset, int length) {
    for (int i = offset; i < offset + length; i++) {
      window[filled++] = bytes[i];
      while (filled > 0 && !mayGrow()) {
        int used = take();
        System.arraycopy(window, used, window, 0, filled - used);
        filled -= used;
      }
    }
  }

  private boolean mayGrow() {
    if (window[0] != 0x02 || (filled > 1 && window[1] != 0x00)) {
      return false;
    }
    return filled < HEAD || (length() > HEAD + TAIL && length() <= LONGEST && filled < length());
  }

  private int length() {
    return HEAD + (window[2] & 0xFF) + ((window[3] & 0xFF) << 8) + TAIL;
  }

  /**
   * Consumes the telegram at the beginning, or one byte that belongs to none; returns the number of
   * bytes.
   */
  private int take() {
    boolean isHead = filled >= HEAD && window[0] == 0x02 && window[1] == 0x00;
    if (!isHead || length() <= HEAD + TAIL || filled < length()) {
      return 1;
    }
    int at = length() - TAIL;
    int check = window[at] & 0xFF | (window[at + 1] & 0xFF) << 8;
    if (check != LmsTelegrams.check(window, 0, at)) {
      sink.damaged();
      return 1;
    }
    sink.command(Arrays.copyOfRange(window, HEAD, at));
    return at + TAIL;
  }
}
