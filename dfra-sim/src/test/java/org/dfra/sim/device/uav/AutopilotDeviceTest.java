package org.dfra.sim.device.uav;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Random;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.device.gps.AntennaTrajectory;
import org.dfra.sim.device.uav.AutopilotSettings.AutopilotSoftware;
import org.dfra.sim.physics.BatteryPhysics.Charge;
import org.dfra.sim.physics.MulticopterPhysics;
import org.junit.jupiter.api.Test;

/**
 * The emulated autopilot, byte by byte and without any driver. Frames were packed field by field
 * from the protocol's definition, checksums bit by bit.
 */
class AutopilotDeviceTest {

  private static final GeoPosition DATUM = new GeoPosition(27.9506, -82.4572, 14.5);
  private static final Instant BEGIN = Instant.parse("2026-01-21T12:53:20Z");

  /** Of a ground station, {@code COMMAND_LONG}: arm. */
  private static final String ARM =
      "FD20000001FFBE4C0000" + "0000803F" + "00000000".repeat(6) + "90010101" + "7004";

  /** The same sent again, confirmation 1. */
  private static final String ARM_AGAIN =
      "FD21000002FFBE4C0000" + "0000803F" + "00000000".repeat(6) + "9001010101" + "8DD8";

  private static final String STATION = "FD09000000FFBE0000000000000006080004033D48";

  private final Still body = new Still();
  private Instant now = BEGIN;

  @Test
  void beginsWithTheHeartbeatOfADisarmedQuadrotor() {
    AutopilotDevice device = device(AutopilotSettings.of(AutopilotSoftware.PX4));
    assertThat(sent(device, Duration.ZERO)).isEmpty();
    // PX4's manual mode is main mode 3: the custom mode 0x00030000, base mode 0x11, standing by
    assertThat(sent(device, Duration.ofSeconds(1)))
        .startsWith("FD09000000010100000000000300020C1103037964");
  }

  @Test
  void answersACommandToItsSender() {
    AutopilotDevice device = device(AutopilotSettings.of(AutopilotSoftware.PX4));
    sent(device, Duration.ofMillis(10));
    receive(device, ARM);
    assertThat(body.rotors).isTrue();
    assertThat(sent(device, Duration.ofMillis(10)))
        .isEqualTo("FD0A00000001014D0000" + "90010000000000" + "00FFBE" + "6A53");
  }

  @Test
  void reportsWhyItDoesNotArmAndArmsWhenTheReasonHasGone() {
    for (AutopilotSoftware software : AutopilotSoftware.values()) {
      AutopilotDevice device =
          device(AutopilotSettings.of(software).withTimeToFirstFix(Duration.ofSeconds(5)));
      sent(device, Duration.ofMillis(10));
      receive(device, ARM);
      String answers = sent(device, Duration.ofMillis(10));
      assertThat(result(answers))
          .isEqualTo(
              software == AutopilotSoftware.PX4
                  ? AutopilotStateMachine.REJECTED_FOR_NOW
                  : AutopilotStateMachine.FAILED);
      assertThat(answers).contains(hex("PreArm: GPS: no 3D fix"));
      sent(device, Duration.ofSeconds(6));
      receive(device, ARM_AGAIN);
      assertThat(result(sent(device, Duration.ofMillis(10))))
          .isEqualTo(AutopilotStateMachine.ACCEPTED);
    }
  }

  @Test
  void disarmsByItselfWhenItStandsArmed() {
    AutopilotDevice device = device(AutopilotSettings.of(AutopilotSoftware.PX4));
    sent(device, Duration.ofMillis(10));
    receive(device, ARM);
    for (int i = 0; i < 90; i++) {
      sent(device, Duration.ofMillis(100));
    }
    assertThat(body.rotors).isTrue();
    sent(device, Duration.ofSeconds(1));
    assertThat(body.rotors).isFalse();
  }

  @Test
  void takesCommandsCutAnywhereAndPassesOverGarbage() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    AutopilotDevice device = device(AutopilotSettings.of(AutopilotSoftware.PX4));
    sent(device, Duration.ofMillis(10));
    byte[] noise = new byte[20_000];
    random.nextBytes(noise);
    device.receive(noise, 0, noise.length, now);
    for (int i = 0; i < 30; i++) { // what noise has begun is over at the latest after 280 bytes
      receive(device, STATION);
    }
    byte[] arm = HexFormat.of().parseHex(ARM);
    for (byte next : arm) {
      device.receive(new byte[] {next}, 0, 1, now);
    }
    assertThat(body.rotors).as("-Ddfra.seed=%d", seed).isTrue();
  }

  @Test
  void executesNoCommandThatIsForAnotherVehicleOrDamaged() {
    AutopilotDevice device = device(AutopilotSettings.of(AutopilotSoftware.PX4));
    sent(device, Duration.ofMillis(10));
    byte[] damaged = HexFormat.of().parseHex(ARM);
    damaged[11] ^= 0x40;
    device.receive(damaged, 0, damaged.length, now);
    String other = "20000001FFBE4C0000" + "0000803F" + "00000000".repeat(6) + "90010201";
    receive(device, "FD" + other + sum(other, 152));
    assertThat(body.rotors).isFalse();
    assertThat(sent(device, Duration.ofMillis(10))).isEmpty();
  }

  @Test
  void saysTheSameAtTheSameTimes() {
    List<String> runs = new ArrayList<>();
    for (int run = 0; run < 2; run++) {
      now = BEGIN;
      AutopilotDevice device = device(AutopilotSettings.of(AutopilotSoftware.ARDUPILOT));
      StringBuilder all = new StringBuilder();
      for (int i = 0; i < 300; i++) {
        if (i == 40) {
          receive(device, ARM);
        }
        all.append(sent(device, Duration.ofMillis(50)));
      }
      runs.add(all.toString());
    }
    assertThat(runs.get(0)).isEqualTo(runs.get(1)).hasSizeGreaterThan(5000);
  }

  private AutopilotDevice device(AutopilotSettings settings) {
    return new AutopilotDevice(
        settings, DATUM, body, AntennaTrajectory.fixed(DATUM), time -> new Charge(15.8, 4.2, 0.87));
  }

  private void receive(AutopilotDevice device, String hex) {
    byte[] bytes = HexFormat.of().parseHex(hex);
    device.receive(bytes, 0, bytes.length, now);
  }

  /** What comes within a step, as hexadecimal digits. */
  private String sent(AutopilotDevice device, Duration step) {
    now = now.plus(step);
    ByteBuffer out = ByteBuffer.allocate(8192);
    device.transmit(out, now);
    now = now.plusMillis(9); // at 92 bytes in a millisecond
    device.transmit(out, now);
    return HexFormat.of().withUpperCase().formatHex(out.array(), 0, out.position());
  }

  /** The result in the one acknowledgement of these bytes; its length depends on the result. */
  private static int result(String hex) {
    int at = hex.indexOf("01014D00009001");
    assertThat(at).as("an answer in %s", hex).isPositive();
    return Integer.parseInt(hex.substring(at + 14, at + 16), 16);
  }

  private static String hex(String text) {
    return HexFormat.of()
        .withUpperCase()
        .formatHex(text.getBytes(java.nio.charset.StandardCharsets.US_ASCII));
  }

  /** CRC-16/MCRF4XX by its textbook form, byte-swapped as it is sent. */
  private static String sum(String hex, int extra) {
    int sum = 0xFFFF;
    byte[] bytes = HexFormat.of().parseHex(hex + HexFormat.of().toHexDigits((byte) extra));
    for (byte next : bytes) {
      int low = next & 0xFF ^ sum & 0xFF;
      low ^= low << 4 & 0xFF;
      sum = sum >> 8 ^ low << 8 ^ low << 3 ^ low >> 4;
    }
    return String.format("%02X%02X", sum & 0xFF, sum >> 8 & 0xFF);
  }

  /** A body that does not move, whatever is commanded. */
  private static final class Still implements MulticopterPhysics {

    private boolean rotors;

    @Override
    public void rotors(Instant time, boolean turn) {
      rotors = turn;
    }

    @Override
    public void fly(Instant time, double east, double north, double up, double speed) {}

    @Override
    public MulticopterState at(Instant time) {
      return new MulticopterState(0, 0, 0, 0, 0, 0, 0, rotors);
    }
  }
}
