package org.dfra.sim.device.drive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.HexFormat;
import org.dfra.sim.physics.BatteryPhysics.Charge;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The controller alone, byte by byte. */
class RflexDeviceTest {

  private static final Instant BEGIN = Instant.parse("2026-01-21T07:33:29Z");
  private static final String RELEASE = "1B0202000C000E1B03";

  /** Half a metre per second by half a metre per second squared. */
  private static final String HALF = "1B02 02 00 07 0E 00 0000AAD3 0000AAD3 00007530 01 4F 1B03";

  private final RecordedWheels wheels = new RecordedWheels(BEGIN);
  private final RflexDevice device = new RflexDevice(wheels, time -> new Charge(25.5, 0, 1));
  private Instant now = BEGIN;

  @BeforeEach
  void switchOn() {
    assertThat(pass(Duration.ZERO)).isEmpty();
  }

  private String pass(Duration duration) {
    now = now.plus(duration);
    ByteBuffer out = ByteBuffer.allocate(4096);
    device.transmit(out, now);
    byte[] bytes = new byte[out.position()];
    out.flip().get(bytes);
    return HexFormat.of().withUpperCase().formatHex(bytes);
  }

  private void say(String hex) {
    byte[] bytes = HexFormat.of().parseHex(hex.replace(" ", ""));
    device.receive(bytes, 0, bytes.length, now);
  }

  @Test
  void reportsBatteryAndBrakeOnRequest() {
    pass(Duration.ofSeconds(1));
    say("1B02 01 00 01 00 00 1B03");
    // 24.30 V are 2430 = 97E hundredths; a million microseconds are F4240
    assertThat(pass(Duration.ofMillis(10)))
        .isEqualTo("1B02" + "01000109" + "000F4240" + "0000097E" + "01" + "72" + "1B03");
  }

  @Test
  void reportsBothAxesOncePerPeriodAtThePaceOfItsLine() {
    say("1B0202002208000186A0000000030C1B03");
    assertThat(pass(Duration.ofMillis(99))).isEmpty();
    assertThat(pass(Duration.ofMillis(1))).isEmpty();
    // 34 bytes of ten bits are 2.95 ms at 115200 baud
    assertThat(pass(Duration.ofNanos(2_940_000))).hasSize(2 * 33);
    assertThat(pass(Duration.ofNanos(20_000))).isEqualTo("03");
    assertThat(pass(Duration.ofMillis(3))).hasSize(2 * 34).startsWith("1B0202002119");
    assertThat(pass(Duration.ofMillis(90))).isEmpty();
    say("1B02020022080000000000000003291B03"); // damaged: it keeps reporting
    assertThat(pass(Duration.ofMillis(20))).hasSize(4 * 34);
    say("1B020200220800000000000000032B1B03");
    assertThat(pass(Duration.ofSeconds(1))).isEmpty();
  }

  @Test
  void doesNotMoveWhileItsBrakeIsSet() {
    say(HALF);
    pass(Duration.ofSeconds(1));
    assertThat(wheels.travel(now).distance()).isZero();
    say(RELEASE);
    pass(Duration.ofSeconds(1));
    assertThat(wheels.travel(now).distance()).as("nothing waits for that").isZero();
    say(HALF);
    pass(Duration.ofMillis(200));
    assertThat(wheels.travel(now).speed()).isCloseTo(0.1, within(1e-5));
    say("1B0202000B00091B03");
    pass(Duration.ofMillis(100));
    assertThat(wheels.travel(now).speed()).isZero();
  }

  @Test
  void standsByItselfWhenNoVelocityComes() {
    say(RELEASE);
    for (int i = 0; i < 20; i++) {
      say("1B02 02 00 07 0E 00 000155A7 000155A7 00007530 01 4F 1B03"); // 1 m/s, 1 m/s²
      pass(Duration.ofMillis(100));
    }
    assertThat(wheels.travel(now).speed()).isCloseTo(1, within(1e-5));
    double driven = wheels.travel(now).distance() - 0.1; // when the last velocity came
    pass(Duration.ofSeconds(3)); // the device was not advanced when it was due
    assertThat(wheels.stand(now)).isTrue();
    // Half of 1 m/s for a sixth of a second, after 0.3 s of it.
    assertThat(wheels.travel(now).distance()).isCloseTo(driven + 0.3 + 0.5 / 6, within(1e-4));
  }

  @Test
  void understandsNoFrameWithAnEscapeInIt() {
    say(RELEASE);
    // 0x1B00 counts/s; the checksum is right
    say("1B02 02 00 07 0E 00 00001B00 0000AAD3 00007530 01 2D 1B03");
    assertThat(wheels.orders).isEmpty();
    assertThat(device.malformedFrames()).isEqualTo(1);
    say(HALF);
    assertThat(wheels.orders).hasSize(1);
  }

  @Test
  void understandsDamageAsNothing() {
    say(RELEASE);
    say("1B02 02 00 07 0E 00 0000AAD3 0000AAD3 00007530 01 4E 1B03"); // checksum
    say("1B02 02 00 07 0D 00 0000AAD3 0000AAD3 00007530 01 4C 1B03"); // length
    say("1B02 02 00 07 1B03");
    say("0000 1B03 FF");
    assertThat(wheels.orders).isEmpty();
    say("1B02 02 00" + HALF); // cut off, and started again
    assertThat(wheels.orders).hasSize(1);
    assertThat(wheels.orders.get(0).speed()).isCloseTo(0.5, within(1e-5));
  }
}
