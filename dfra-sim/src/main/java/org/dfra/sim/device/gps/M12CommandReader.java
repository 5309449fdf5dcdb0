package org.dfra.sim.device.gps;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Map;

/** Parses commands from the bytes that a computer sends. Confined to one thread. */
final class M12CommandReader {

  /** Receives parsed commands. */
  @FunctionalInterface
  interface Sink {

    /**
     * Handles one command.
     *
     * @param id its two letters
     * @param argument the bytes between ID and checksum
     */
    void command(String id, byte[] argument);
  }

  /** Total lengths of the known commands. */
  private static final Map<String, Integer> LENGTHS =
      Map.ofEntries(
          Map.entry("Ha", 8),
          Map.entry("Hb", 8),
          Map.entry("Hn", 8),
          Map.entry("Ea", 8),
          Map.entry("En", 22),
          Map.entry("Bb", 8),
          Map.entry("Bo", 8),
          Map.entry("Aw", 8),
          Map.entry("At", 8),
          Map.entry("Gd", 8),
          Map.entry("Ge", 8),
          Map.entry("Gb", 17),
          Map.entry("As", 20),
          Map.entry("Cj", 7),
          Map.entry("Cf", 7));

  private final Sink sink;
  private final byte[] window = new byte[22];
  private int filled;

  M12CommandReader(Sink sink) {
    this.sink = sink;
  }

  void feed(byte[] bytes, int offset, int length) {
    for (int i = offset; i < offset + length; i++) {
      window[filled++] = bytes[i];
      while (filled > 0 && !mayGrow()) {
        int used = Math.max(1, commandLength());
        System.arraycopy(window, used, window, 0, filled - used);
        filled -= used;
      }
    }
  }

  /** Whether the bytes so far may be an incomplete command. */
  private boolean mayGrow() {
    if (window[0] != '@' || (filled > 1 && window[1] != '@')) {
      return false;
    }
    return filled < 4 || filled < LENGTHS.getOrDefault(id(), 0);
  }

  /** Executes the command at the beginning; returns its length, 0 when there is none. */
  private int commandLength() {
    int length = filled < 4 ? 0 : LENGTHS.getOrDefault(id(), 0);
    if (length == 0 || filled < length) {
      return 0;
    }
    int sum = 0;
    for (int i = 2; i < length - 2; i++) {
      sum ^= window[i]; // the checksum makes it zero
    }
    if (window[0] != '@' || window[1] != '@' || (sum & 0xFF) != 0) {
      return 0;
    }
    if (window[length - 2] != '\r' || window[length - 1] != '\n') {
      return 0;
    }
    sink.command(id(), Arrays.copyOfRange(window, 4, length - 3));
    return length;
  }

  private String id() {
    return new String(window, 2, 2, StandardCharsets.US_ASCII);
  }
}
