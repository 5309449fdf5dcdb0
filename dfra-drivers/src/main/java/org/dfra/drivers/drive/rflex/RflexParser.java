package org.dfra.drivers.drive.rflex;

import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.FrameParser;
import org.dfra.drivers.frame.FrameScanner;

/** Parses the bytes of an rFLEX controller into messages. */
final class RflexParser extends FrameParser<RflexMessage> {

  /**
   * @param messages receives every message, in order, during {@link #feed} and {@link #finish}
   */
  public RflexParser(Consumer<? super RflexMessage> messages) {
    super(
        new RflexFramer(),
        RflexDecoder::decode,
        RflexMessage.Malformed.class::isInstance,
        messages);
  }

  /** Decodes a whole recording. */
  public static List<RflexMessage> parse(byte[] bytes) {
    return parse(bytes, RflexParser::new);
  }

  /**
   * Finds the frames of an rFLEX controller: {@code 1B 02, port, id, opcode, length, data,
   * checksum, 1B 03}. It uses the length, because the controller's numbers may contain 1B like any
   * other byte. The lengths of the supported frames are known, so a corrupted length does not delay
   * it.
   */
  static final class RflexFramer extends FrameScanner {

    static final int ESCAPE = 0x1B;
    static final int START = 0x02;
    static final int END = 0x03;

    /** Bytes before the data. */
    static final int HEAD = 6;

    /** Bytes around the data. */
    static final int AROUND = 9;

    private static final int LONGEST_DATA = 255;

    /** Makes a framer at the beginning of a stream. */
    public RflexFramer() {
      super(LONGEST_DATA + AROUND);
    }

    @Override
    protected int frameLengthAt(byte[] bytes, int at, int end) {
      int there = end - at;
      if (bytes[at] != ESCAPE || (there > 1 && bytes[at + 1] != START)) {
        return NONE;
      }
      if (there < HEAD) {
        return NEEDS_MORE;
      }
      int port = bytes[at + 2] & 0xFF;
      int data = bytes[at + 5] & 0xFF;
      if (!RflexDecoder.isKnownLength(port, bytes[at + 4] & 0xFF, data)) {
        return NONE;
      }
      int length = data + AROUND;
      if (there < length) {
        return NEEDS_MORE;
      }
      return isIntact(bytes, at, length) ? length : NONE;
    }

    private static boolean isIntact(byte[] bytes, int at, int length) {
      int last = at + length - 1;
      return bytes[last] == END
          && bytes[last - 1] == ESCAPE
          && (bytes[last - 2] & 0xFF) == checksum(bytes, at + 2, last - 2);
    }

    /** Exclusive or of the bytes {@code from} to before {@code to}. */
    static int checksum(byte[] bytes, int from, int to) {
      int sum = 0;
      for (int i = from; i < to; i++) {
        sum ^= bytes[i];
      }
      return sum & 0xFF;
    }
  }
}
