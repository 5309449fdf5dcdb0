package org.dfra.drivers.gps.ubx;

import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.frame.FrameParser;
import org.dfra.drivers.frame.FrameScanner;

/** Parses the bytes of UBX into messages. */
public final class UbxParser extends FrameParser<UbxMessage> {

  /**
   * @param messages receives every message, in order, during {@link #feed} and {@link #finish}
   */
  public UbxParser(Consumer<? super UbxMessage> messages) {
    super(new UbxFramer(), UbxDecoder::decode, UbxMessage.Malformed.class::isInstance, messages);
  }

  /** Decodes a whole recording. */
  public static List<UbxMessage> parse(byte[] bytes) {
    return parse(bytes, UbxParser::new);
  }

  /**
   * Finds the frames of UBX. The lengths of the supported messages are known, so a corrupted length
   * does not make the scanner wait for bytes that never arrive.
   */
  static final class UbxFramer extends FrameScanner {

    /** Class and ID of {@code NAV-PVT}. */
    static final int NAV_PVT = 0x0107;

    /** Class and ID of {@code NAV-SAT}. */
    static final int NAV_SAT = 0x0135;

    /** Class and ID of {@code ACK-NAK}. */
    static final int ACK_NAK = 0x0500;

    /** Class and ID of {@code ACK-ACK}. */
    static final int ACK_ACK = 0x0501;

    /** Class and ID of {@code MON-VER}. */
    static final int MON_VER = 0x0A04;

    /** Bytes before the payload. */
    static final int HEAD = 6;

    /** Bytes around the payload. */
    static final int AROUND = 8;

    /** Longest payload: {@code NAV-SAT} with the maximum of its satellite count. */
    private static final int LONGEST_PAYLOAD = 8 + 12 * 255;

    private static final int LONGEST_OTHER = 1024;

    /** A framer at the beginning of a stream. */
    public UbxFramer() {
      super(LONGEST_PAYLOAD + AROUND);
    }

    @Override
    protected int frameLengthAt(byte[] bytes, int at, int end) {
      int there = end - at;
      if (bytes[at] != (byte) 0xB5 || (there > 1 && bytes[at + 1] != 0x62)) {
        return NONE;
      }
      if (there < HEAD) {
        return NEEDS_MORE;
      }
      int type = (bytes[at + 2] & 0xFF) << 8 | (bytes[at + 3] & 0xFF);
      int payload = (bytes[at + 4] & 0xFF) | (bytes[at + 5] & 0xFF) << 8;
      if (!isLengthOf(type, payload)) {
        return NONE;
      }
      int length = payload + AROUND;
      if (there < length) {
        return NEEDS_MORE;
      }
      return isIntact(bytes, at, length) ? length : NONE;
    }

    private static boolean isLengthOf(int type, int payload) {
      return switch (type) {
        case NAV_PVT -> payload == 92 || payload == 84; // 84 before protocol version 14
        case NAV_SAT -> payload >= 8 && payload <= LONGEST_PAYLOAD && (payload - 8) % 12 == 0;
        case ACK_ACK, ACK_NAK -> payload == 2;
        case MON_VER -> payload >= 40 && payload <= LONGEST_OTHER && (payload - 40) % 30 == 0;
        default -> payload <= LONGEST_OTHER;
      };
    }

    private static boolean isIntact(byte[] bytes, int at, int length) {
      int sum = checksum(bytes, at + 2, at + length - 2);
      return bytes[at + length - 2] == (byte) sum && bytes[at + length - 1] == (byte) (sum >> 8);
    }

    /** Fletcher's checksum: the first byte is the low one. */
    static int checksum(byte[] bytes, int from, int to) {
      int a = 0;
      int b = 0;
      for (int i = from; i < to; i++) {
        a += bytes[i];
        b += a;
      }
      return (b & 0xFF) << 8 | (a & 0xFF);
    }
  }
}
