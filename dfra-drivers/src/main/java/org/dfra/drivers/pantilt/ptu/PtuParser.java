package org.dfra.drivers.pantilt.ptu;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.FrameParser;
import org.dfra.drivers.frame.FrameScanner;
import org.dfra.drivers.pantilt.ptu.PtuCommands.PtuAxis;
import org.dfra.drivers.pantilt.ptu.PtuReply.Done;
import org.dfra.drivers.pantilt.ptu.PtuReply.LimitHit;
import org.dfra.drivers.pantilt.ptu.PtuReply.Refused;
import org.dfra.drivers.pantilt.ptu.PtuReply.Value;

/** Parses bytes into replies: combines {@link PtuFramer} and {@link PtuDecoder}. */
final class PtuParser extends FrameParser<PtuReply> {

  /** Passes every reply in the stream to {@code replies}. */
  public PtuParser(Consumer<? super PtuReply> replies) {
    // Any text is a reply; only the sender of the query can check it.
    super(new PtuFramer(), PtuDecoder::decode, reply -> false, replies);
  }

  /** Decodes a whole recording. */
  public static List<PtuReply> parse(byte[] bytes) {
    return parse(bytes, PtuParser::new);
  }

  /**
   * Finds replies: {@code *}, {@code * text} and {@code ! text}, each with a carriage return, and
   * preceded by the line feed that may end the previous line; and {@code !P} and {@code !T}, which
   * have no end mark and count only if a line end or another reply follows directly.
   *
   * <p>Echoes, and the text that the unit prints when it is switched on, are not replies and are
   * dropped. There is no checksum: a corrupted reply is not detected here.
   */
  static final class PtuFramer extends FrameScanner {

    /** Longest reply: the copyright notice in the firmware's version, and a margin. */
    public static final int LONGEST = 200;

    /** A framer at the beginning of a stream. */
    public PtuFramer() {
      super(LONGEST);
    }

    @Override
    protected int frameLengthAt(byte[] bytes, int at, int end) {
      int from = bytes[at] == '\n' ? at + 1 : at;
      if (end - from < 2) {
        return from == end || isMark(bytes[from]) ? NEEDS_MORE : NONE;
      }
      if (!isMark(bytes[from])) {
        return NONE;
      }
      byte next = bytes[from + 1];
      if (bytes[from] == '!' && (next == 'P' || next == 'T')) {
        return limit(bytes, at, from, end);
      }
      return next == ' ' || next == '\r' ? line(bytes, at, from + 1, end) : NONE;
    }

    private static int limit(byte[] bytes, int at, int from, int end) {
      if (from + 2 == end) {
        return NEEDS_MORE;
      }
      byte after = bytes[from + 2];
      boolean isAlone = after == '\r' || after == '\n' || isMark(after);
      return isAlone ? from + 2 - at : NONE;
    }

    private static int line(byte[] bytes, int at, int from, int end) {
      int limit = Math.min(end, at + LONGEST);
      for (int i = from; i < limit; i++) {
        byte next = bytes[i];
        if (next == '\r') {
          return i + 1 - at;
        }
        if (next < ' ' || next > '~' || isMark(next)) {
          return NONE;
        }
      }
      return end - at < LONGEST ? NEEDS_MORE : NONE;
    }

    private static boolean isMark(byte envelope) {
      return envelope == '*' || envelope == '!';
    }
  }

  /**
   * Decodes the replies that a {@link PtuParser.PtuFramer} has found. Never throws, whatever the
   * bytes.
   */
  static final class PtuDecoder {

    private PtuDecoder() {}

    /** Decodes one reply. */
    public static PtuReply decode(byte[] bytes, int offset, int length) {
      String line = new String(bytes, offset, length, StandardCharsets.US_ASCII).strip();
      if (line.equals("!P") || line.equals("!T")) {
        return new LimitHit(line.endsWith("P") ? PtuAxis.PAN : PtuAxis.TILT);
      }
      String text = line.isEmpty() ? "" : line.substring(1).strip();
      if (line.startsWith("!")) {
        return new Refused(text);
      }
      return text.isEmpty() ? new Done() : new Value(text);
    }
  }
}
