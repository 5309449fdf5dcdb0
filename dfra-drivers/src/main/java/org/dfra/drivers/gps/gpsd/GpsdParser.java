package org.dfra.drivers.gps.gpsd;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.FrameParser;
import org.dfra.drivers.frame.FrameScanner;

/** Parses the bytes of gpsd's protocol into messages. */
public final class GpsdParser extends FrameParser<GpsdMessage> {

  /**
   * @param messages receives every message, in order, during {@link #feed} and {@link #finish}
   */
  public GpsdParser(Consumer<? super GpsdMessage> messages) {
    super(new GpsdFramer(), GpsdDecoder::decode, GpsdMessage.Malformed.class::isInstance, messages);
  }

  /** Decodes a whole recording. */
  public static List<GpsdMessage> parse(byte[] bytes) {
    return parse(bytes, GpsdParser::new);
  }

  /**
   * Finds gpsd's objects: a line that begins with a class and whose braces and brackets close
   * exactly at its end. The decoder checks whether the rest is JSON.
   */
  static final class GpsdFramer extends FrameScanner {

    /** Longest line: a sky of some hundred satellites. */
    public static final int LONGEST = 32 * 1024;

    private static final byte[] HEAD = "{\"class\":\"".getBytes(StandardCharsets.US_ASCII);

    /**
     * Characters allowed outside strings, besides braces and brackets: numbers, true, false and
     * null.
     */
    private static final boolean[] OUTSIDE = outside();

    /** A framer at the beginning of a stream. */
    public GpsdFramer() {
      super(LONGEST);
    }

    @Override
    protected int frameLengthAt(byte[] bytes, int at, int end) {
      int head = Math.min(HEAD.length, end - at);
      for (int i = 0; i < head; i++) {
        if (bytes[at + i] != HEAD[i]) {
          return NONE;
        }
      }
      int limit = Math.min(end, at + LONGEST);
      int closed = closing(bytes, at, limit);
      if (closed == NONE || closed == NEEDS_MORE) {
        return closed == NEEDS_MORE && end - at < LONGEST ? NEEDS_MORE : NONE;
      }
      int last = closed < limit && bytes[closed] == '\r' ? closed + 1 : closed;
      if (last == limit) {
        return end - at < LONGEST ? NEEDS_MORE : NONE;
      }
      return bytes[last] == '\n' ? last + 1 - at : NONE;
    }

    /** Index after the brace that closes the first one; NONE or NEEDS_MORE. */
    private static int closing(byte[] bytes, int at, int limit) {
      int depth = 0;
      boolean inText = false;
      for (int i = at; i < limit; i++) {
        byte next = bytes[i];
        if (next >= 0 && next < ' ') {
          return NONE; // control characters are not allowed
        }
        if (inText) {
          if (next == '\\') {
            i++;
          } else if (next == '"') {
            inText = false;
          }
        } else if (next == '"') {
          inText = true;
        } else if (next == '{' || next == '[') {
          depth++;
        } else if (next == '}' || next == ']') {
          depth--;
          if (depth == 0) {
            return i + 1;
          }
        } else if (next < 0 || !OUTSIDE[next]) {
          return NONE;
        }
      }
      return NEEDS_MORE;
    }

    private static boolean[] outside() {
      boolean[] allowed = new boolean[128];
      for (char each : "0123456789+-.eE,: trufalsn".toCharArray()) {
        allowed[each] = true;
      }
      return allowed;
    }
  }
}
