package org.dfra.drivers.laser.lms;

import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.FrameParser;
import org.dfra.drivers.frame.FrameScanner;

/**
 * Parses the laser's bytes into messages. A NAK counts as malformed too: it is a single byte that
 * is frequent in noise, so it does not show that there is a laser.
 */
public final class LmsParser extends FrameParser<LmsMessage> {

  /**
   * @param messages receives every message, in order, during {@link #feed} and {@link #finish}
   */
  public LmsParser(Consumer<? super LmsMessage> messages) {
    super(new LmsFramer(), LmsDecoder::decode, LmsParser::isMalformed, messages);
  }

  private static boolean isMalformed(LmsMessage message) {
    return message instanceof LmsMessage.Malformed || message instanceof LmsMessage.Nak;
  }

  /** Decodes a whole recording. */
  public static List<LmsMessage> parse(byte[] bytes) {
    return parse(bytes, LmsParser::new);
  }

  /**
   * Finds the laser's telegrams. An ACK right before a telegram belongs to it; a NAK is a frame of
   * its own. Telegrams to the laser, such as an echo of the driver's own, are not frames.
   */
  static final class LmsFramer extends FrameScanner {

    static final int ACK = 0x06;
    static final int NAK = 0x15;
    static final int STX = 0x02;

    /** Address of a laser's replies. */
    static final int REPLY = 0x80;

    /** Bytes before the payload. */
    static final int HEAD = 4;

    /** Bytes after the payload. */
    static final int TAIL = 2;

    /** Command and status. */
    private static final int SHORTEST_PAYLOAD = 2;

    /** A scan of 401 beams with both its counters. */
    private static final int LONGEST_PAYLOAD = 3 + 2 * 401 + 2 + 1;

    private static final int LONGEST = 1 + HEAD + LONGEST_PAYLOAD + TAIL;

    /** A framer at the beginning of a stream. */
    public LmsFramer() {
      super(LONGEST);
    }

    @Override
    protected int frameLengthAt(byte[] bytes, int at, int end) {
      int first = bytes[at];
      if (first == NAK) {
        return 1;
      }
      if (first != ACK) {
        return telegramAt(bytes, at, end);
      }
      if (end - at == 1) {
        return NEEDS_MORE;
      }
      int length = telegramAt(bytes, at + 1, end);
      return length > 0 ? 1 + length : length;
    }

    private static int telegramAt(byte[] bytes, int at, int end) {
      int there = end - at;
      if (bytes[at] != STX || (there > 1 && (bytes[at + 1] & 0xFF) != REPLY)) {
        return NONE;
      }
      if (there < HEAD) {
        return NEEDS_MORE;
      }
      int payload = u16(bytes, at + 2);
      if (payload < SHORTEST_PAYLOAD || payload > LONGEST_PAYLOAD) {
        return NONE;
      }
      if (there > HEAD && bytes[at + HEAD] >= 0) { // a reply's command is 80 hex or more
        return NONE;
      }
      int crcAt = at + HEAD + payload;
      if (crcAt + TAIL > end) {
        return NEEDS_MORE;
      }
      return LmsCrc.of(bytes, at, crcAt) == u16(bytes, crcAt) ? HEAD + payload + TAIL : NONE;
    }

    static int u16(byte[] bytes, int at) {
      return bytes[at] & 0xFF | (bytes[at + 1] & 0xFF) << 8;
    }
  }

  /** The CRC of a telegram: SICK's own 16 bits, over all bytes before it. */
  static final class LmsCrc {

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
}
