package org.dfra.attack.fuzz;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

/**
 * Changes valid bytes at random: flips bits, sets bytes, cuts the end, removes, inserts and repeats
 * ranges. With the same random numbers it does the same.
 *
 * <p>Some texts are kept, such as addresses: a changed one would make the attacked process ask name
 * servers outside the test.
 */
final class ByteMutator {

  /** Most changes of one message. */
  private static final int CHANGES = 4;

  private static final int LONGEST_RANGE = 64;
  private static final int REPETITIONS = 64;
  private static final int LONGEST = 60_000; // a datagram

  private final Random random;
  private final List<byte[]> kept;

  /**
   * @param kept texts of ASCII characters that are not changed
   */
  ByteMutator(Random random, List<String> kept) {
    this.random = random;
    this.kept = kept.stream().map(text -> text.getBytes(StandardCharsets.US_ASCII)).toList();
  }

  /** A changed copy. */
  byte[] mutate(byte[] valid) {
    byte[] bytes = valid.clone();
    int changes = 1 + random.nextInt(CHANGES);
    for (int i = 0; i < changes && bytes.length > 0; i++) {
      bytes = change(bytes);
    }
    return bytes;
  }

  private byte[] change(byte[] bytes) {
    int at = position(bytes);
    return switch (random.nextInt(6)) {
      case 0 -> set(bytes, at, (byte) (bytes[at] ^ 1 << random.nextInt(8)));
      case 1 -> set(bytes, at, (byte) random.nextInt(256));
      case 2 -> Arrays.copyOf(bytes, at);
      case 3 -> replace(bytes, at, end(bytes, at), new byte[0]);
      case 4 -> {
        byte[] inserted = new byte[1 + random.nextInt(LONGEST_RANGE)];
        random.nextBytes(inserted);
        yield replace(bytes, at, at, inserted);
      }
      default -> repeat(bytes, at);
    };
  }

  /** A position that is not within a kept text; the first one if there is no other. */
  private int position(byte[] bytes) {
    for (int attempt = 0; attempt < bytes.length; attempt++) {
      int at = random.nextInt(bytes.length);
      if (!isKept(bytes, at)) {
        return at;
      }
    }
    return 0;
  }

  /** The end of a range that splits no kept text: after {@code at}, up to the longest range. */
  private int end(byte[] bytes, int at) {
    int end = Math.min(bytes.length, at + 1 + random.nextInt(LONGEST_RANGE));
    while (end < bytes.length && isKept(bytes, end)) {
      end++;
    }
    return end;
  }

  private boolean isKept(byte[] bytes, int at) {
    for (byte[] text : kept) {
      int last = Math.min(at, bytes.length - text.length);
      for (int from = Math.max(0, at - text.length + 1); from <= last; from++) {
        if (Arrays.equals(bytes, from, from + text.length, text, 0, text.length)) {
          return true;
        }
      }
    }
    return false;
  }

  private static byte[] set(byte[] bytes, int at, byte value) {
    bytes[at] = value;
    return bytes;
  }

  private byte[] repeat(byte[] bytes, int at) {
    byte[] range = Arrays.copyOfRange(bytes, at, end(bytes, at));
    int most = Math.max(1, Math.min(REPETITIONS, (LONGEST - bytes.length) / range.length));
    int times = 1 + random.nextInt(most);
    byte[] repeated = new byte[times * range.length];
    for (int i = 0; i < times; i++) {
      System.arraycopy(range, 0, repeated, i * range.length, range.length);
    }
    return replace(bytes, at, at, repeated);
  }

  /** With other bytes between two positions. */
  private static byte[] replace(byte[] bytes, int from, int to, byte[] by) {
    byte[] result = new byte[bytes.length - (to - from) + by.length];
    System.arraycopy(bytes, 0, result, 0, from);
    System.arraycopy(by, 0, result, from, by.length);
    System.arraycopy(bytes, to, result, from + by.length, bytes.length - to);
    return result;
  }
}
