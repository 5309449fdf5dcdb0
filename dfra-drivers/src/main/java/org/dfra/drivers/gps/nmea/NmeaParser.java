package org.dfra.drivers.gps.nmea;

import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.FrameParser;
import org.dfra.drivers.frame.FrameScanner;

/** Parses the bytes of NMEA 0183 into sentences. */
public final class NmeaParser extends FrameParser<NmeaSentence> {

  /**
   * @param messages receives every message, in order, during {@link #feed} and {@link #finish}
   */
  public NmeaParser(Consumer<? super NmeaSentence> messages) {
    super(
        new NmeaFramer(),
        new NmeaDecoder()::decode,
        NmeaSentence.Malformed.class::isInstance,
        messages);
  }

  /** Decodes a whole recording. */
  public static List<NmeaSentence> parse(byte[] bytes) {
    return parse(bytes, NmeaParser::new);
  }

  /**
   * Finds sentences: a {@code $}, printable characters, a correct checksum, the end of the line.
   *
   * <p>A sentence without a checksum is accepted only on a stream that has had no sentence with
   * one; otherwise it counts as corrupted.
   */
  static final class NmeaFramer extends FrameScanner {

    /**
     * Longest sentence, with the end of its line. The standard allows 82, but proprietary sentences
     * are longer.
     */
    public static final int LONGEST = 256;

    /** Shortest: {@code $AABBB}. */
    private static final int HEAD = 6;

    private boolean checksums;

    /** A framer at the beginning of a stream. */
    public NmeaFramer() {
      super(LONGEST);
    }

    @Override
    public void finish(Sink sink) {
      super.finish(sink);
      checksums = false;
    }

    @Override
    protected int frameLengthAt(byte[] bytes, int at, int end) {
      if (bytes[at] != '$') {
        return NONE;
      }
      int limit = Math.min(end, at + LONGEST);
      int star = -1;
      int sum = 0;
      for (int i = at + 1; i < limit; i++) {
        byte next = bytes[i];
        if (next == '\n') {
          return isIntact(bytes, at, i, star, sum) ? i + 1 - at : NONE;
        }
        if (next == '\r') {
          if (i + 1 < limit && bytes[i + 1] != '\n') {
            return NONE;
          }
        } else if (next < ' ' || next > '~' || next == '$') {
          return NONE;
        } else if (next == '*') {
          star = star < 0 ? i : star;
        } else if (star < 0) {
          sum ^= next;
        }
      }
      return end - at < LONGEST ? NEEDS_MORE : NONE;
    }

    private boolean isIntact(byte[] bytes, int at, int newline, int star, int sum) {
      int last = bytes[newline - 1] == '\r' ? newline - 1 : newline; // exclusive
      if (last - at < HEAD) {
        return false;
      }
      if (star < 0) {
        return !checksums;
      }
      boolean right = last - star == 3 && (hex(bytes[star + 1]) << 4 | hex(bytes[star + 2])) == sum;
      checksums |= right;
      return right;
    }

    /** The digit's value; for another character a negative value that no checksum equals. */
    private static int hex(byte digit) {
      if (digit >= '0' && digit <= '9') {
        return digit - '0';
      }
      if (digit >= 'A' && digit <= 'F') {
        return digit - 'A' + 10;
      }
      return digit >= 'a' && digit <= 'f' ? digit - 'a' + 10 : -256;
    }
  }
}
