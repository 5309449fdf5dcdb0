package org.dfra.sim.device.gyro;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dfra.sim.physics.GyroInput;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The gyro alone, stepped. */
class Dsp3000DeviceTest {

  private static final Instant BEGIN = Instant.parse("2026-11-21T10:00:00Z");

  private Instant now = BEGIN;

  @Test
  void sendsAHundredLinesASecondClockwise() {
    Dsp3000Device gyro = gyro(time -> Math.toRadians(-12.5), Duration.ZERO);
    List<String> lines = run(gyro, Duration.ofSeconds(1)).lines().toList();
    assertThat(lines).hasSizeBetween(99, 100).allMatch("12.500000 1"::equals);
  }

  @Test
  void isNotValidWhileItStartsOrTurnsTooFast() {
    Dsp3000Device cold = gyro(time -> 0, Duration.ofMillis(500));
    assertThat(run(cold, Duration.ofMillis(490))).contains("-0.000000 0\r\n").doesNotContain(" 1");
    run(cold, Duration.ofMillis(20));
    assertThat(run(cold, Duration.ofMillis(100)))
        .contains("-0.000000 1\r\n")
        .doesNotContain(" 0\r");
    Dsp3000Device spun = gyro(time -> Math.toRadians(-400), Duration.ZERO);
    assertThat(run(spun, Duration.ofMillis(100))).startsWith("375.000000 0\r\n");
  }

  @ParameterizedTest
  @CsvSource({
    "0.5, 0.500000",
    "-0.5, -0.500000",
    "-0.0000004, -0.000000",
    "1.000001, 1.000001",
    "-374.0123456, -374.012346",
    "374.9999998, 375.000000",
  })
  void writesSixPlaces(double rate, String written) {
    Dsp3000Device gyro = gyro(time -> Math.toRadians(-rate), Duration.ZERO);
    assertThat(run(gyro, Duration.ofMillis(100))).startsWith(written + " 1\r\n");
  }

  @Test
  void sendsAnglesInItsOtherModes() {
    Dsp3000Device gyro = gyro(time -> Math.toRadians(-50), Duration.ZERO);
    say(gyro, "AAA");
    assertThat(run(gyro, Duration.ofMillis(100))).startsWith("0.500000 1\r\n");
    say(gyro, "PPPZZZ");
    String angles = run(gyro, Duration.ofMillis(1000));
    assertThat(angles).endsWith("\r\n").contains("1.500000 1\r\n2.000000 1\r\n", "\r\n49.000000 1");
    say(gyro, "R");
    run(gyro, Duration.ofMillis(20));
    assertThat(run(gyro, Duration.ofMillis(100))).contains("50.000000 1\r\n");
  }

  @Test
  void asksForTheRateInOrderAndOncePerLine() {
    Instant[] last = {BEGIN};
    int[] asked = {0};
    Dsp3000Device gyro =
        gyro(
            time -> {
              assertThat(time).isAfter(last[0]);
              last[0] = time;
              asked[0]++;
              return 0;
            },
            Duration.ZERO);
    exchange(gyro, "");
    now = now.plusMillis(500); // late, by fifty lines
    exchange(gyro, "");
    assertThat(asked[0]).isEqualTo(50);
    assertThat(last[0]).isEqualTo(now);
  }

  private static Dsp3000Device gyro(GyroInput view, Duration warmUp) {
    return new Dsp3000Device(view, 38_400, warmUp);
  }

  private String run(Dsp3000Device gyro, Duration length) {
    StringBuilder output = new StringBuilder(exchange(gyro, ""));
    for (long millis = 0; millis < length.toMillis(); millis += 5) {
      now = now.plusMillis(5);
      output.append(exchange(gyro, ""));
    }
    return output.toString();
  }

  private void say(Dsp3000Device gyro, String text) {
    exchange(gyro, text);
    now = now.plusMillis(9); // what was on the line before is through
    exchange(gyro, "");
  }

  private String exchange(Dsp3000Device gyro, String text) {
    byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
    gyro.receive(bytes, 0, bytes.length, now);
    ByteBuffer out = ByteBuffer.allocate(4096);
    gyro.transmit(out, now);
    return new String(out.array(), 0, out.position(), StandardCharsets.US_ASCII);
  }
}
