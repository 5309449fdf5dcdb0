package org.dfra.drivers.gps.m12;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.dfra.drivers.frame.FrameParser;
import org.dfra.drivers.frame.FrameScanner;
import org.dfra.drivers.gps.m12.M12Message.MalformedMessage;

/** Parses the bytes of Motorola's binary protocol into messages. */
public final class M12Parser extends FrameParser<M12Message> {

  /**
   * @param messages receives every message, in order, during {@link #feed} and {@link #finish}
   */
  public M12Parser(Consumer<? super M12Message> messages) {
    super(new M12Framer(), M12Decoder::decode, MalformedMessage.class::isInstance, messages);
  }

  /** Decodes a whole recording. */
  public static List<M12Message> parse(byte[] bytes) {
    return parse(bytes, M12Parser::new);
  }

  /** Finds the frames of Motorola's binary protocol. */
  static final class M12Framer extends FrameScanner {

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

  /**
   * The total length in bytes of every frame that a receiver sends, from the first {@code @} to the
   * line feed. Source: Motorola Oncore M12+ user's guide, message summary.
   */
  static final class M12Lengths {

    /** The longest frame: the receiver identification. */
    public static final int LONGEST = 294;

    private static final Map<String, Integer> TABLE = table();
    private static final short[] BY_ID = byId();

    private M12Lengths() {}

    /**
     * The length of a frame.
     *
     * @param id1 first byte after {@code @@}, as a signed byte
     * @param id2 second byte after {@code @@}
     * @return bytes; 0 when no frame has this ID
     */
    public static int of(byte id1, byte id2) {
      return id1 < 'A' || id1 > 'Z' || id2 < 'A' || id2 > 'z' ? 0 : BY_ID[index(id1, id2)];
    }

    /** All lengths by ID, for example 154 for {@code Ha}. */
    public static Map<String, Integer> all() {
      return TABLE;
    }

    private static int index(int id1, int id2) {
      return (id1 - 'A') << 6 | (id2 - 'A');
    }

    private static Map<String, Integer> table() {
      TreeMap<String, Integer> lengths = new TreeMap<>();
      put(lengths, 154, "Ha");
      put(lengths, 54, "Hb");
      put(lengths, 78, "Hn");
      put(lengths, 76, "Ea");
      put(lengths, 69, "En");
      put(lengths, 92, "Bb");
      put(lengths, 68, "Ba");
      put(lengths, 59, "Bn");
      put(lengths, LONGEST, "Cj");
      put(lengths, 33, "Cb");
      put(lengths, 21, "Gj");
      put(lengths, 20, "Ga", "As");
      put(lengths, 17, "Gb");
      put(lengths, 11, "Ay", "Az");
      put(lengths, 10, "Ia");
      put(lengths, 9, "Gf", "Ca", "Fa");
      put(lengths, 8, "Gc", "Gd", "Ge", "Aw", "At", "Bo", "Bj", "Ag");
      put(lengths, 7, "Cf");
      return Map.copyOf(lengths);
    }

    private static void put(Map<String, Integer> lengths, int length, String... ids) {
      for (String id : ids) {
        lengths.put(id, length);
      }
    }

    private static short[] byId() {
      short[] lengths = new short[26 << 6];
      TABLE.forEach(
          (id, length) -> lengths[index(id.charAt(0), id.charAt(1))] = length.shortValue());
      return lengths;
    }
  }
}
