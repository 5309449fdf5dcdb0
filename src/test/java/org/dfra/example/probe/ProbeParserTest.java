package org.dfra.example.probe;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.dfra.drivers.frame.StreamCounts;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class ProbeParserTest {

  private final List<Double> reported = new ArrayList<>();
  private final ProbeParser parser = new ProbeParser(reported::add);

  /** Two seeds that never change and the run's; a failing test shows its own. */
  static long[] seeds() {
    return new long[] {1, 2, Long.getLong("dfra.seed", new Random().nextLong())};
  }

  @ParameterizedTest
  @ValueSource(doubles = {21.5, 0, -0.25, -55, 125})
  void readsWhatTheProbeSends(double celsius) {
    feed(ProbeDevice.line(celsius));
    assertThat(reported).containsExactly(celsius);
  }

  @ParameterizedTest
  @ValueSource(strings = {"T+125.01", "T-055.01", "T---.---", "T+1E1.00", "T+NaN.00", "T**--**T"})
  void countsAnIntactLineWithoutATemperature(String text) {
    feed(ProbeDevice.checked(text.substring(0, 8)));
    assertThat(reported).containsExactly(Double.NaN);
    assertThat(parser.counts()).isEqualTo(new StreamCounts(1, 0, 1));
  }

  @ParameterizedTest(name = "-Ddfra.seed={0}")
  @MethodSource("seeds")
  void isInStepAgainByTheNextIntactLineAfterAnyGarbage(long seed) {
    Random random = new Random(seed);
    ByteArrayOutputStream stream = new ByteArrayOutputStream();
    List<Double> expected = new ArrayList<>();
    while (expected.size() < 5_000) {
      byte[] garbage = new byte[random.nextInt(30)];
      for (int i = 0; i < garbage.length; i++) {
        garbage[i] = (byte) "T+-8.*\nP".charAt(random.nextInt(8)); // the worst there is
      }
      stream.writeBytes(garbage);
      double celsius = Math.rint(random.nextDouble() * 100) / 4;
      stream.writeBytes(ProbeDevice.line(celsius));
      expected.add(celsius);
    }
    byte[] bytes = stream.toByteArray();
    for (int at = 0, part; at < bytes.length; at += part) {
      part = Math.min(1 + random.nextInt(40), bytes.length - at);
      parser.feed(bytes, at, part);
    }
    parser.finish();
    // No line can hide in this garbage: its only digit is 8, and no exclusive or of ASCII is 88.
    // (With 0 one did: of T**--**T it is 00.)
    assertThat(reported).isEqualTo(expected);
    assertThat(parser.counts().droppedBytes()).isEqualTo(bytes.length - 12L * expected.size());
  }

  @ParameterizedTest(name = "-Ddfra.seed={0}")
  @MethodSource("seeds")
  void neverThrowsOnNoise(long seed) {
    byte[] noise = new byte[200_000];
    new Random(seed).nextBytes(noise);
    feed(noise);
    StreamCounts counts = parser.counts();
    assertThat(counts.droppedBytes() + 12 * counts.frames()).isEqualTo(noise.length);
  }

  @Test
  void reportsALineWithItsLastByte() {
    byte[] line = ProbeDevice.line(21.5);
    parser.feed(line, 0, 11);
    assertThat(reported).isEmpty();
    parser.feed(line, 11, 1);
    assertThat(reported).hasSize(1);
  }

  private void feed(byte[] bytes) {
    parser.feed(bytes, 0, bytes.length);
    parser.finish();
  }
}
