package org.dfra.drivers.drive.rflex;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.ByteBuffer;
import java.util.HexFormat;
import java.util.Random;
import org.dfra.drivers.drive.rflex.RflexCommands.EscapeFreeNumbers;
import org.dfra.drivers.drive.rflex.RflexMessage.Axis;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

class RflexCommandsTest {

  private static final int COUNT = Boolean.getBoolean("dfra.full") ? 20_000_000 : 300_000;

  /** Twice the fastest there is, 1 m/s. */
  private static final int FASTEST = 2 * 90_810;

  private static String hex(byte[] frame) {
    return HexFormat.ofDelimiter(" ").withUpperCase().formatHex(frame);
  }

  @Test
  void saysWhatTheDocumentedExamplesSay() {
    assertThat(hex(RflexCommands.brake(false))).isEqualTo("1B 02 02 00 0C 00 0E 1B 03");
    assertThat(hex(RflexCommands.reports(100_000)))
        .isEqualTo("1B 02 02 00 22 08 00 01 86 A0 00 00 00 03 0C 1B 03");
    assertThat(hex(RflexCommands.velocity(Axis.TRANSLATION, 43_731, 43_731, 30_000)))
        .isEqualTo("1B 02 02 00 07 0E 00 00 00 AA D3 00 00 AA D3 00 00 75 30 01 4F 1B 03");
  }

  @Test
  void saysTheRest() {
    assertThat(hex(RflexCommands.brake(true))).isEqualTo("1B 02 02 00 0B 00 09 1B 03");
    assertThat(hex(RflexCommands.defaults())).isEqualTo("1B 02 02 00 0A 00 08 1B 03");
    assertThat(hex(RflexCommands.status())).isEqualTo("1B 02 01 00 01 00 00 1B 03");
    assertThat(hex(RflexCommands.velocity(Axis.ROTATION, -36_277, 36_277, 30_000)))
        .isEqualTo("1B 02 02 00 07 0E 01 00 00 8D B5 00 00 8D B5 00 00 75 30 00 4F 1B 03");
  }

  @ParameterizedTest
  @CsvSource({
    "0, 0",
    "26, 26",
    "27, 26", // of two equally near the smaller
    "6911, 6911",
    "6912, 6911", // 1B00
    "7039, 6911", // 1B7F: 128 either way
    "7040, 7168", // 1B80
    "7167, 7168", // 1BFF
    "65563, 65562", // 1 00 1B
    "1769472, 1769471", // 1B 00 00
    "4294967295, 4294967295",
  })
  void choosesTheNearestNumberWithoutAnEscape(long value, long nearest) {
    assertThat(EscapeFreeNumbers.nearest(value)).isEqualTo(nearest);
  }

  @Test
  void choosesTheNearestForEveryVelocityThereIs() {
    for (int value = 0; value <= FASTEST; value++) {
      long chosen = EscapeFreeNumbers.nearest(value);
      int distance = 0;
      while (!isFree(value - distance) && !isFree(value + distance)) {
        distance++;
      }
      if (Math.abs(chosen - value) != distance || !isFree(chosen)) {
        throw new AssertionError(
            "%d for %d; one that is %d away is free".formatted(chosen, value, distance));
      }
    }
  }

  private static boolean isFree(long value) {
    for (byte each : ByteBuffer.allocate(Long.BYTES).putLong(value).array()) {
      if (each == 0x1B) {
        return false;
      }
    }
    return true;
  }

  @Test
  void noFrameOfAnyVelocityHasAnEscapeInIt() {
    for (int velocity = -FASTEST; velocity <= FASTEST; velocity++) {
      Axis axis = Axis.values()[velocity & 1];
      byte[] frame = RflexCommands.velocity(axis, velocity, 612_239, 30_000);
      assertClean(frame);
      assertSays(frame, axis, velocity, 612_239, 30_000);
    }
  }

  static long[] seeds() {
    return new long[] {1, Long.getLong("dfra.seed", new Random().nextLong())};
  }

  @ParameterizedTest(name = "-Ddfra.seed={0}")
  @MethodSource("seeds")
  void noFrameOfAnyNumbersHasAnEscapeInIt(long seed) {
    Random random = new Random(seed);
    for (int i = 0; i < COUNT; i++) {
      Axis axis = Axis.values()[random.nextInt(2)];
      long velocity = any(random) * (random.nextBoolean() ? 1 : -1);
      long acceleration = any(random);
      long torque = any(random);
      byte[] frame = RflexCommands.velocity(axis, velocity, acceleration, torque);
      assertClean(frame);
      assertSays(frame, axis, velocity, acceleration, torque);
      assertClean(RflexCommands.reports(any(random)));
    }
  }

  /** Any number of four bytes, with more 1B in it than chance has. */
  private static long any(Random random) {
    long value = random.nextInt() & 0xFFFF_FFFFL;
    for (int shift = 0; shift < 32; shift += 8) {
      int kind = random.nextInt(4);
      value = kind == 0 ? value & ~(0xFFL << shift) | 0x1BL << shift : value;
      value = kind == 1 ? value & ~(0xFFL << shift) : value;
    }
    return value;
  }

  private static void assertClean(byte[] frame) {
    for (int i = 2; i < frame.length - 2; i++) {
      if (frame[i] == 0x1B) {
        throw new AssertionError("1B at " + i + " of " + hex(frame));
      }
    }
    int sum = 0;
    for (int i = 2; i < frame.length - 2; i++) {
      sum ^= frame[i]; // the checksum makes it zero
    }
    if (sum != 0) {
      throw new AssertionError("a wrong checksum in " + hex(frame));
    }
  }

  /** Plain comparisons: assertions of AssertJ take a hundred times as long as what they look at. */
  private static void assertSays(
      byte[] frame, Axis axis, long velocity, long acceleration, long torque) {
    ByteBuffer data = ByteBuffer.wrap(frame, 6, 14);
    boolean isSaid =
        data.get() == axis.ordinal()
            && number(data) == EscapeFreeNumbers.nearest(Math.abs(velocity))
            && number(data) == EscapeFreeNumbers.nearest(acceleration)
            && isNear(number(data), torque)
            && data.get() == (velocity < 0 ? 0 : 1);
    if (!isSaid) {
      throw new AssertionError(
          "%s, velocity %d, acceleration %d, torque %d became %s"
              .formatted(axis, velocity, acceleration, torque, hex(frame)));
    }
  }

  private static long number(ByteBuffer data) {
    return data.getInt() & 0xFFFF_FFFFL;
  }

  private static boolean isNear(long chosen, long torque) {
    long nearest = EscapeFreeNumbers.nearest(torque);
    return chosen == nearest // else the checksum was in the way
        || Math.abs(chosen - torque) <= Math.abs(nearest - torque) + 260;
  }

  @Test
  void refusesNumbersThatDoNotFit() {
    assertThatThrownBy(() -> RflexCommands.velocity(Axis.ROTATION, 1L << 32, 1, 1))
        .hasMessage("4294967296 is outside 0 to 4294967295");
    assertThatThrownBy(() -> RflexCommands.velocity(Axis.ROTATION, 1, 1, -1))
        .hasMessage("-1 is outside 0 to 4294967295");
  }
}
