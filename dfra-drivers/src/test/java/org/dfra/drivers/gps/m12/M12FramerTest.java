package org.dfra.drivers.gps.m12;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.TreeSet;
import org.dfra.drivers.gps.m12.M12Parser.M12Framer;
import org.dfra.drivers.gps.m12.M12Parser.M12Lengths;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class M12FramerTest {

  private static final int BYTES = Boolean.getBoolean("dfra.full") ? 10_000_000 : 1_000_000;
  private static final List<String> IDS = List.copyOf(new TreeSet<>(M12Lengths.all().keySet()));

  /** Three seeds that never change and the run's; a failing test shows its own. */
  static long[] seeds() {
    return new long[] {1, 2, 3, Long.getLong("dfra.seed", new Random().nextLong())};
  }

  /** Where a frame is in a stream. */
  private record Place(int offset, int length) {}

  @ParameterizedTest(name = "-Ddfra.seed={0}")
  @MethodSource("seeds")
  void findsEveryFrameBetweenGarbageAndCountsEveryByteOfIt(long seed) {
    Random random = new Random(seed);
    ByteArrayOutputStream stream = new ByteArrayOutputStream();
    List<Place> expected = new ArrayList<>();
    while (stream.size() < BYTES) {
      byte[] garbage = new byte[random.nextInt(4) == 0 ? random.nextInt(300) : 0];
      random.nextBytes(garbage);
      stream.writeBytes(garbage);
      byte[] frame = randomFrame(random);
      expected.add(new Place(stream.size(), frame.length));
      stream.writeBytes(frame);
    }
    byte[] bytes = stream.toByteArray();
    Run run = new Run();
    run.feedInRandomCuts(bytes, random);
    assertThat(run.places).isEqualTo(expected);
    assertThat(run.framer.droppedBytes()).isEqualTo(bytes.length - lengthOf(expected));
    assertThat(run.framer.frames()).isEqualTo(expected.size());
  }

  @ParameterizedTest(name = "-Ddfra.seed={0}")
  @MethodSource("seeds")
  void isInStepAgainWithTheNextIntactFrameAfterAnyDamage(long seed) {
    Random random = new Random(seed);
    ByteArrayOutputStream stream = new ByteArrayOutputStream();
    List<Place> intact = new ArrayList<>();
    while (stream.size() < BYTES) {
      byte[] frame = randomFrame(random);
      switch (random.nextInt(6)) {
        case 0 -> // a flipped bit
            frame[random.nextInt(frame.length)] ^= (byte) (1 << random.nextInt(8));
        case 1 -> // a cut frame, the worst garbage: a right head with the wrong rest
            frame = Arrays.copyOf(frame, random.nextInt(frame.length));
        case 2 -> { // a head alone, or half of one
          byte[] head = ("@@@" + IDS.get(random.nextInt(IDS.size()))).getBytes();
          frame = Arrays.copyOfRange(head, random.nextInt(3), 1 + 2 + random.nextInt(3));
        }
        case 3 -> { // a missing byte
          int missing = random.nextInt(frame.length);
          System.arraycopy(frame, missing + 1, frame, missing, frame.length - missing - 1);
          frame = Arrays.copyOf(frame, frame.length - 1);
        }
        default -> intact.add(new Place(stream.size(), frame.length));
      }
      stream.writeBytes(frame);
    }
    byte[] bytes = stream.toByteArray();
    Run run = new Run();
    run.feedInRandomCuts(bytes, random);
    assertThat(run.places).isEqualTo(scanned(bytes));
    assertThat(run.framer.droppedBytes()).isEqualTo(bytes.length - lengthOf(run.places));
    // A cut frame and what follows it may by chance make a right frame (1 in 256 of those whose
    // ends meet), which no receiver can distinguish; then a frame inside it is missed.
    List<Place> missed = new ArrayList<>(intact);
    missed.removeAll(new java.util.HashSet<>(run.places));
    assertThat(missed).allMatch(place -> isCovered(place, run.places));
    assertThat(missed.size()).isLessThan(intact.size() / 100);
  }

  @ParameterizedTest(name = "-Ddfra.seed={0}")
  @MethodSource("seeds")
  void neverThrowsOnNoise(long seed) {
    Random random = new Random(seed);
    byte[] noise = new byte[BYTES];
    random.nextBytes(noise);
    for (int i = 0; i < BYTES / 10; i++) { // plenty of what frames are made of
      noise[random.nextInt(BYTES)] = (byte) "@@@@HaEaCj\r\n".charAt(random.nextInt(12));
    }
    Run run = new Run();
    run.feedInRandomCuts(noise, random);
    assertThat(run.framer.droppedBytes() + lengthOf(run.places)).isEqualTo(BYTES);
  }

  @Test
  void reportsAFrameWithItsLastByte() {
    Run run = new Run();
    byte[] frame = M12Commands.encode("Gd", 3);
    for (int i = 0; i < frame.length; i++) {
      assertThat(run.places).isEmpty();
      run.framer.feed(frame, i, 1, run::take);
    }
    assertThat(run.places).hasSize(1);
    assertThat(run.framer.pendingBytes()).isZero();
  }

  @Test
  void keepsAFalseHeadWaitingUntilTheStreamEnds() {
    Run run = new Run();
    byte[] head = "@@Cj".getBytes();
    byte[] frame = M12Commands.encode("Gd", 3);
    run.framer.feed(head, 0, head.length, run::take);
    run.framer.feed(frame, 0, frame.length, run::take);
    assertThat(run.places).isEmpty();
    assertThat(run.framer.pendingBytes()).isEqualTo(12);
    run.framer.finish(run::take);
    assertThat(run.framer.frames()).isEqualTo(1);
    assertThat(run.framer.droppedBytes()).isEqualTo(4);
  }

  @Test
  void knowsTheLengthsOfTheGuideAndNoOthers() {
    assertThat(M12Lengths.all()).hasSize(29).containsEntry("Ha", 154).containsEntry("Cj", 294);
    int known = 0;
    for (int id1 = -128; id1 < 128; id1++) {
      for (int id2 = -128; id2 < 128; id2++) {
        int length = M12Lengths.of((byte) id1, (byte) id2);
        known += length > 0 ? 1 : 0;
        assertThat(length)
            .isEqualTo(M12Lengths.all().getOrDefault("" + (char) id1 + (char) id2, 0));
      }
    }
    assertThat(known).isEqualTo(29);
  }

  /** A framer and what it found; every frame is also decoded, which must not throw either. */
  private static final class Run {

    final M12Framer framer = new M12Framer();
    final List<Place> places = new ArrayList<>();

    void feedInRandomCuts(byte[] bytes, Random random) {
      for (int at = 0; at < bytes.length; ) {
        int part =
            Math.min(1 + random.nextInt(random.nextBoolean() ? 20 : 9000), bytes.length - at);
        framer.feed(bytes, at, part, this::take);
        at += part;
        assertThat(framer.droppedBytes() + lengthOf + framer.pendingBytes()).isEqualTo(at);
      }
      framer.finish(this::take);
      assertThat(framer.pendingBytes()).isZero();
    }

    private int lengthOf;

    void take(byte[] buffer, int offset, int length) {
      places.add(new Place((int) framer.droppedBytes() + lengthOf, length));
      lengthOf += length;
      assertThat(M12Decoder.decode(buffer, offset, length)).isNotNull();
    }
  }

  private static byte[] randomFrame(Random random) {
    String id = IDS.get(random.nextInt(IDS.size()));
    int[] payload = new int[M12Lengths.all().get(id) - 7];
    for (int i = 0; i < payload.length; i++) {
      payload[i] = random.nextInt(256);
    }
    return M12Commands.encode(id, payload);
  }

  /** The frames of a whole stream, found in the plainest way there is. */
  private static List<Place> scanned(byte[] bytes) {
    List<Place> places = new ArrayList<>();
    int at = 0;
    while (at + 4 <= bytes.length) {
      Integer length = M12Lengths.all().get("" + (char) bytes[at + 2] + (char) bytes[at + 3]);
      if (bytes[at] == '@'
          && bytes[at + 1] == '@'
          && length != null
          && at + length <= bytes.length
          && bytes[at + length - 1] == '\n'
          && bytes[at + length - 2] == '\r') {
        int sum = 0;
        for (int i = at + 2; i < at + length - 2; i++) {
          sum ^= bytes[i] & 0xFF;
        }
        if (sum == 0) {
          places.add(new Place(at, length));
          at += length;
          continue;
        }
      }
      at++;
    }
    return places;
  }

  private static boolean isCovered(Place place, List<Place> found) {
    int index = 0;
    int low = 0;
    int high = found.size() - 1;
    while (low <= high) { // the last one found that begins before the place ends
      int middle = (low + high) >>> 1;
      if (found.get(middle).offset() < place.offset() + place.length()) {
        index = middle;
        low = middle + 1;
      } else {
        high = middle - 1;
      }
    }
    return found.get(index).offset() + found.get(index).length() > place.offset();
  }

  private static int lengthOf(List<Place> places) {
    return places.stream().mapToInt(Place::length).sum();
  }
}
