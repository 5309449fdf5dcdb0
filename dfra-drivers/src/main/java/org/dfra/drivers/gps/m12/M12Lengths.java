package org.dfra.drivers.gps.m12;

import java.util.Map;
import java.util.TreeMap;

/**
 * The total length in bytes of every frame that a receiver sends, from the first {@code @} to the
 * line feed. Source: Motorola Oncore M12+ user's guide, message summary.
 */
public final class M12Lengths {

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
    TABLE.forEach((id, length) -> lengths[index(id.charAt(0), id.charAt(1))] = length.shortValue());
    return lengths;
  }
}
