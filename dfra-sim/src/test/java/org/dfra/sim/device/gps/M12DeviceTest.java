package org.dfra.sim.device.gps;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import org.dfra.drivers.gps.m12.M12Commands;
import org.dfra.drivers.gps.m12.M12Message;
import org.dfra.drivers.gps.m12.M12Message.HeldPosition;
import org.dfra.drivers.gps.m12.M12Message.M12UtcOffset;
import org.dfra.drivers.gps.m12.M12Message.PositionControl;
import org.dfra.drivers.gps.m12.M12Message.ReceiverClock;
import org.dfra.drivers.gps.m12.M12Message.TimeRaim;
import org.dfra.drivers.gps.m12.M12Message.TimeScale;
import org.dfra.drivers.gps.m12.M12Message.VisibleSatellites;
import org.dfra.drivers.gps.m12.M12Parser;
import org.dfra.drivers.gps.m12.M12PositionMessage;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.GeoPosition;
import org.junit.jupiter.api.Test;

/** The protocol alone, stepped; commands are the ready frames of the user's guide. */
class M12DeviceTest {

  private static final Instant BEGIN = Instant.parse("2026-01-21T07:33:29.250Z");
  private static final String HA_EVERY_SECOND = "40404861 01 28 0D0A";
  private static final String HA_EVERY_THREE = "40404861 03 2A 0D0A";
  private static final String HA_ONCE = "40404861 00 29 0D0A";
  private static final String EA_EVERY_SECOND = "40404561 01 25 0D0A";
  private static final String CJ = "4040436A 29 0D0A";
  private static final String GPS_TIME = "40404177 00 36 0D0A";
  private static final String ASK_TIME_SCALE = "40404177 FF C9 0D0A";

  private final List<M12Message> received = new ArrayList<>();
  private final M12Parser parser = new M12Parser(received::add);
  private final M12Device device = device(9600, Duration.ZERO);
  private Instant now = BEGIN;

  @Test
  void saysNothingUnasked() {
    assertThat(run(device, Duration.ofSeconds(10))).isZero();
  }

  @Test
  void sendsAtOnceAndThenAtItsRate() {
    command(device, HA_EVERY_THREE);
    run(device, Duration.ofSeconds(10));
    assertThat(times("Ha"))
        .containsExactly(BEGIN, BEGIN.plusSeconds(3), BEGIN.plusSeconds(6), BEGIN.plusSeconds(9));
  }

  @Test
  void aFrameTakesAsLongAsTheLineNeedsForIt() {
    command(device, HA_EVERY_SECOND);
    assertThat(run(device, Duration.ofMillis(160))).isEqualTo(153); // 960 bytes/s
    assertThat(received).isEmpty();
    assertThat(run(device, Duration.ofMillis(1))).isEqualTo(1);
    assertThat(received).hasSize(1);
  }

  @Test
  void sendsOnceAndStopsItsRate() {
    command(device, HA_EVERY_SECOND);
    run(device, Duration.ofMillis(500));
    command(device, HA_ONCE);
    run(device, Duration.ofSeconds(10));
    assertThat(times("Ha")).containsExactly(BEGIN, BEGIN.plusMillis(500));
  }

  @Test
  void sendsBothFamiliesWhenAskedForBoth() {
    command(device, HA_EVERY_SECOND + EA_EVERY_SECOND);
    run(device, Duration.ofMillis(2900));
    assertThat(received.stream().map(M12Message::id))
        .containsExactly("Ha", "Ea", "Ha", "Ea", "Ha", "Ea");
    assertThat(parser.counts().droppedBytes()).isZero();
  }

  @Test
  void saysWhatItIs() {
    command(device, CJ);
    assertThat(run(device, Duration.ofSeconds(1))).isEqualTo(294);
    assertThat(received).singleElement().extracting(M12Message::id).isEqualTo("Cj");
  }

  @Test
  void changesAndReportsItsTimeScale() {
    command(device, ASK_TIME_SCALE + GPS_TIME + HA_ONCE);
    run(device, Duration.ofSeconds(1));
    assertThat(received.get(0)).isEqualTo(new TimeScale(true));
    assertThat(received.get(1)).isEqualTo(new TimeScale(false));
    M12PositionMessage position = (M12PositionMessage) received.get(2);
    assertThat(position.time().toInstant()).isEqualTo(BEGIN.plusSeconds(18));
    assertThat(position.utc()).isEqualTo(BEGIN);
  }

  @Test
  void holdsItsPositionWhenItIsCommanded() {
    say(M12Commands.positionControl(PositionControl.Mode.HOLD));
    say(M12Commands.shortPosition(0));
    say(M12Commands.askHoldPosition());
    run(device, Duration.ofSeconds(1));
    assertThat(received.get(0)).isEqualTo(new PositionControl(PositionControl.Mode.HOLD));
    M12PositionMessage position = (M12PositionMessage) received.get(1);
    assertThat(position.id()).isEqualTo("Hb");
    assertThat(position.mode()).isEqualTo(GpsFix.Mode.POSITION_HOLD);
    assertThat(((HeldPosition) received.get(2)).position()).isEqualTo(position.position());
  }

  @Test
  void reportsItsSatellitesTheirIntegrityAndTheOffsetOfUtc() {
    say(M12Commands.visibleSatellites(false));
    say(M12Commands.timeRaimOf12Channels(0));
    say(M12Commands.timeRaimOn());
    say(M12Commands.timeRaimOf12Channels(0));
    say(M12Commands.timeRaimOf8Channels(0));
    say(M12Commands.utcOffset());
    run(device, Duration.ofSeconds(1));
    assertThat(((VisibleSatellites) received.get(0)).satellites()).hasSize(9);
    assertThat(((TimeRaim) received.get(1)).solution()).isEqualTo(TimeRaim.Solution.UNKNOWN);
    assertThat(received.get(2).id()).isEqualTo("Ge");
    assertThat(((TimeRaim) received.get(3)).solution()).isEqualTo(TimeRaim.Solution.OK);
    assertThat(((TimeRaim) received.get(4)).sawtooth()).isEqualTo(-7);
    assertThat(received.get(5)).isEqualTo(new M12UtcOffset(18));
  }

  @Test
  void takesTheTimeWhileItHasNoFixAndKnowsBetterAfterwards() {
    M12Device cold = device(9600, Duration.ofSeconds(2));
    Instant wrong = Instant.parse("2001-02-03T04:05:06Z");
    byte[] set = M12Commands.time(wrong);
    cold.receive(set, 0, set.length, now);
    command(cold, HA_ONCE);
    run(cold, Duration.ofSeconds(3));
    cold.receive(set, 0, set.length, now);
    run(cold, Duration.ofSeconds(1));
    assertThat(((ReceiverClock) received.get(0)).time().toInstant()).isEqualTo(wrong);
    assertThat(((M12PositionMessage) received.get(1)).utc()).isEqualTo(wrong);
    assertThat(((ReceiverClock) received.get(2)).time().toInstant())
        .as("it knows better")
        .isEqualTo("2026-01-21T07:33:32Z");
  }

  @Test
  void ignoresWhatItDoesNotKnowAndWhatIsDamaged() {
    command(
        device,
        "FF 40 4040 0D0A" // noise
            + "40404861 01 29 0D0A" // wrong checksum
            + "40404861 01 28 0D0B" // wrong end
            + "40404762 01 02 03" // no command it knows
            + "40404177 07 31 0D0A" // no time scale
            + "40404861"); // cut short by the next
    command(device, CJ);
    run(device, Duration.ofSeconds(1));
    assertThat(received).singleElement().extracting(M12Message::id).isEqualTo("Cj");
  }

  @Test
  void understandsACommandByteByByte() {
    for (byte b : HexFormat.of().parseHex(CJ.replace(" ", ""))) {
      device.receive(new byte[] {b}, 0, 1, now);
    }
    run(device, Duration.ofSeconds(1));
    assertThat(received).hasSize(1);
  }

  @Test
  void searchesForItsSatellitesFirst() {
    M12Device cold = device(9600, Duration.ofSeconds(2));
    command(cold, HA_EVERY_SECOND);
    run(cold, Duration.ofMillis(3500));
    assertThat(received.stream().map(message -> ((M12PositionMessage) message).mode()))
        .containsExactly(
            GpsFix.Mode.NONE, GpsFix.Mode.NONE, GpsFix.Mode.FIX_3D, GpsFix.Mode.FIX_3D);
  }

  @Test
  void leavesMessagesOutWhenTheLineIsTooSlow() {
    M12Device slow = device(600, Duration.ZERO); // 60 bytes/s for 154 bytes/s
    command(slow, HA_EVERY_SECOND);
    run(slow, Duration.ofMinutes(2));
    assertThat(received.size()).isBetween(40, 47); // 7200 bytes through, in whole frames
    assertThat(parser.counts().droppedBytes()).isZero();
  }

  @Test
  void sendsOneFrameForManyTimesSleptThrough() {
    command(device, HA_EVERY_SECOND);
    run(device, Duration.ofMillis(500));
    now = now.plusSeconds(60);
    run(device, Duration.ofMillis(300)); // to second 60.8: 60 is the last one due
    assertThat(times("Ha")).containsExactly(BEGIN, BEGIN.plusSeconds(60));
  }

  @Test
  void goesOnWhenTheClockIsSetBack() {
    command(device, HA_EVERY_SECOND);
    run(device, Duration.ofMillis(500));
    now = now.minusSeconds(3600);
    Instant back = now;
    run(device, Duration.ofMillis(1500));
    assertThat(times("Ha")).hasSize(2).element(1).isEqualTo(back.plusSeconds(1).plusMillis(1));
  }

  private M12Device device(int baud, Duration timeToFirstFix) {
    GeoPosition place = new GeoPosition(52.910313611, 6.866706667, 55.91);
    return new M12Device(AntennaTrajectory.fixed(place), baud, timeToFirstFix);
  }

  private void say(byte[] command) {
    device.receive(command, 0, command.length, now);
  }

  private void command(M12Device to, String hex) {
    byte[] bytes = HexFormat.of().parseHex(hex.replace(" ", ""));
    to.receive(bytes, 0, bytes.length, now);
  }

  /** Lets time go by in steps of a millisecond; returns how many bytes came out. */
  private int run(M12Device of, Duration time) {
    int count = 0;
    ByteBuffer out = ByteBuffer.allocate(4096);
    for (long i = 0; i < time.toMillis(); i++) {
      now = now.plusMillis(1);
      out.clear();
      of.transmit(out, now);
      parser.feed(out.array(), 0, out.position());
      count += out.position();
    }
    return count;
  }

  private List<Instant> times(String id) {
    return received.stream()
        .filter(message -> message.id().equals(id))
        .map(message -> ((M12PositionMessage) message).utc())
        .toList();
  }
}
