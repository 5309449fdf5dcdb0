package org.dfra.drivers.uav.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.drivers.fixture.Modules.await;
import static org.dfra.drivers.fixture.Modules.awaitReadiness;
import static org.dfra.drivers.fixture.Modules.parameter;
import static org.dfra.drivers.fixture.Modules.texts;

import io.dronefleet.mavlink.common.MavCmd;
import java.time.Duration;
import java.time.Instant;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.drivers.fixture.ScriptedLink;
import org.dfra.drivers.fixture.StepTicker;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.FlightCommand.GoTo;
import org.dfra.flow.effector.FlightState;
import org.dfra.flow.effector.FlightState.Phase;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.module.NotReadyException;
import org.dfra.module.Readiness;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The modules on a link that says what the test has it say, on stepped time. */
@Timeout(120)
class MavlinkModulesTest {

  private static final byte[] HEARTBEAT =
      hex("FD09000011010100000000000403020C9D0403DE49"); // PX4, armed, in the air
  private static final byte[] POSITION =
      hex("FD1C000007010121000040E2010050ECA810A007DACE24F40000204E00002C0170FECEFF0C7B14BD");
  private static final byte[] RECEIVER =
      hex(
          "FD2C000008010118000000909B68E548060050ECA810A007DACE409C00005A007800F401DF77030B"
              + "A4380000DC050000C40900002C01285C");
  private static final byte[] FLIES = hex("FD0200000A0101F5000000024E27");
  private static final byte[] SUPPLY =
      hex(
          "FD1F00000B0101010000000000000000000000000000FA00B83DD204000000000000000000000000"
              + "57024D");
  private static final byte[] BATTERY =
      hex(
          "FD2400000D0101930000FFFFFFFFFFFFFFFFFF7FA00FA00F3C0F3C0FFFFFFFFFFFFFFFFFFFFFFFFF"
              + "6AFF0000013F4737");

  /** {@code COMMAND_ACK} of {@code DO_SET_MODE}, 176. */
  private static final byte[] MODE_ACCEPTED =
      summed(hex("FD030000010101" + "4D0000" + "B000000000"), 143);

  private final StepTicker ticker = new StepTicker(false);
  private final List<ScriptedLink> links = new CopyOnWriteArrayList<>();
  private final LinkKeeper.Source source =
      () -> {
        ScriptedLink link = new ScriptedLink("tcp://uav:1");
        links.add(link);
        return link;
      };

  @Test
  void putsTheStateOfAFlightTogether() {
    try (MavlinkFlightImpl flight = new MavlinkFlightImpl(context("flight"), ticker, source)) {
      flight.start();
      say(HEARTBEAT, RECEIVER, FLIES, POSITION);
      awaitReadiness(flight, Readiness.READY);
      FlightState state = flight.flight();
      assertThat(state.phase()).isEqualTo(Phase.IN_AIR);
      assertThat(state.isArmed()).isTrue();
      // 62.5 m above the sea; the receiver says 40 m where it says 14.5 m above the ellipsoid
      assertThat(state.position().height()).isEqualTo(37.0);
      assertThat(state.position().latitude()).isEqualTo(27.9506);
      assertThat(state.height()).isEqualTo(20.0);
      assertThat(state.heading()).isEqualTo(315.0);
      assertThat(state.speed()).isEqualTo(5.0); // 3 m/s north, 4 m/s west
      assertThat(state.climb()).isEqualTo(0.5);
    }
  }

  @Test
  void holdsItsPlacePastACommandThatHangsInTheLink() throws Exception {
    try (MavlinkFlightImpl flight = new MavlinkFlightImpl(context("flight"), ticker, source)) {
      flight.start();
      say(HEARTBEAT, RECEIVER, FLIES, POSITION);
      awaitReadiness(flight, Readiness.READY);
      CommandLease lease = flight.command(Duration.ofSeconds(10));
      CountDownLatch release = new CountDownLatch(1);
      ScriptedLink link = links.get(0);
      link.holdUpAWrite(release);
      GoTo away = new GoTo(flight.flight().position(), 3);
      CompletableFuture<Void> writing =
          CompletableFuture.runAsync(
              () -> flight.obey(lease.key(), away), run -> new Thread(run).start());
      try {
        await().until(() -> isSent(link, MavCmd.MAV_CMD_DO_REPOSITION));
        assertThat(isSent(link, MavCmd.MAV_CMD_DO_SET_MODE)).isFalse();
        assertThat(flight.emergencyStop("ops").latched()).isTrue();
        await().until(() -> isSent(link, MavCmd.MAV_CMD_DO_SET_MODE));
        assertThat(writing).isNotDone();
      } finally {
        release.countDown();
      }
      writing.get(60, TimeUnit.SECONDS);
      await().until(() -> modesSet(link) == 2);
      say(MODE_ACCEPTED); // the first of them; the second was lost
      await().until(() -> parameter(flight, "last_order").endsWith("DO_SET_MODE is accepted"));
      ticker.step(Duration.ofMillis(2100));
      await("the second is sent again").until(() -> modesSet(link) == 3);
      say(HEARTBEAT, MODE_ACCEPTED);
      await().until(() -> link.isTaken());
      link.awaitLooked();
      ticker.step(Duration.ofMillis(2100));
      link.awaitLooked();
      assertThat(modesSet(link)).as("it is at rest").isEqualTo(3);
    }
  }

  @Test
  void holdsItsPlacePastAWriteOfTheReaderThatHangsAndOnceMoreAfterIt() throws Exception {
    try (MavlinkFlightImpl flight = new MavlinkFlightImpl(context("flight"), ticker, source)) {
      flight.start();
      say(HEARTBEAT, RECEIVER, FLIES, POSITION);
      awaitReadiness(flight, Readiness.READY);
      CommandLease lease = flight.command(Duration.ofSeconds(10));
      ScriptedLink link = links.get(0);
      flight.obey(lease.key(), new GoTo(flight.flight().position(), 3));
      link.awaitLooked();
      CountDownLatch release = new CountDownLatch(1);
      link.holdUpTheReader(release);
      long written = link.written().size();
      try {
        ticker.step(Duration.ofMillis(750)); // unanswered, so it is sent again
        await().until(() -> link.written().size() > written);
        assertThat(isSent(link, MavCmd.MAV_CMD_DO_SET_MODE)).isFalse();
        assertThat(flight.emergencyStop("ops").latched()).isTrue();
        await().until(() -> isSent(link, MavCmd.MAV_CMD_DO_SET_MODE));
        await().until(() -> flight.stopState().resting());
      } finally {
        release.countDown();
      }
      link.awaitLooked();
      ticker.step(Duration.ofMillis(2100));
      await("as what the vehicle did not accept").until(() -> modesSet(link) >= 2);
    }
  }

  private static long modesSet(ScriptedLink link) {
    return link.written().stream()
        .filter(each -> isCommand(each, MavCmd.MAV_CMD_DO_SET_MODE))
        .count();
  }

  @Test
  void aModuleEndsThoughItsCommandHangsInTheLink() throws Exception {
    MavlinkFlightImpl flight = new MavlinkFlightImpl(context("flight"), ticker, source);
    CountDownLatch release = new CountDownLatch(1);
    try {
      flight.start();
      say(HEARTBEAT, RECEIVER, FLIES, POSITION);
      awaitReadiness(flight, Readiness.READY);
      CommandLease lease = flight.command(Duration.ofSeconds(10));
      ScriptedLink link = links.get(0);
      link.holdUpAWrite(release);
      GoTo away = new GoTo(flight.flight().position(), 3);
      CompletableFuture<Void> writing =
          CompletableFuture.runAsync(
              () -> flight.obey(lease.key(), away), run -> new Thread(run).start());
      await().until(() -> isSent(link, MavCmd.MAV_CMD_DO_REPOSITION));
      link.awaitLooked(); // the reader goes on
      CompletableFuture.runAsync(flight::close, run -> new Thread(run).start())
          .get(40, TimeUnit.SECONDS);
      assertThat(link.isOpen()).isFalse();
      assertThat(writing).isNotDone();
    } finally {
      release.countDown();
      flight.close();
    }
  }

  @Test
  void aVehicleThatFallsSilentWhileACommandHangsIsNoticed() throws Exception {
    CountDownLatch release = new CountDownLatch(1);
    try (MavlinkFlightImpl flight = new MavlinkFlightImpl(context("flight"), ticker, source)) {
      flight.start();
      say(HEARTBEAT, RECEIVER, FLIES, POSITION);
      awaitReadiness(flight, Readiness.READY);
      CommandLease lease = flight.command(Duration.ofSeconds(10));
      ScriptedLink link = links.get(0);
      link.holdUpAWrite(release);
      GoTo away = new GoTo(flight.flight().position(), 3);
      CompletableFuture<Void> writing =
          CompletableFuture.runAsync(
              () -> flight.obey(lease.key(), away), run -> new Thread(run).start());
      try {
        await().until(() -> isSent(link, MavCmd.MAV_CMD_DO_REPOSITION));
        ticker.step(Duration.ofMillis(3100));
        await("closing it may set the command free").until(() -> !link.isOpen());
        assertThat(writing).isNotDone();
      } finally {
        release.countDown();
      }
    }
  }

  /** By the number of the command, which stands behind 28 bytes of a {@code COMMAND_LONG}. */
  private static boolean isCommand(byte[] frame, MavCmd command) {
    return frame.length > 40
        && (frame[7] == 76 || frame[7] == 75)
        && ((frame[38] & 0xFF) | (frame[39] & 0xFF) << 8) == MavlinkEncoder.number(command);
  }

  private static boolean isSent(ScriptedLink link, MavCmd command) {
    return link.written().stream().anyMatch(each -> isCommand(each, command));
  }

  @Test
  void hasNoPositionWhereItDoesNotKnowTheGeoidAndTakesASeparationThatIsSet() {
    try (MavlinkFlightImpl flight = new MavlinkFlightImpl(context("flight"), ticker, source)) {
      flight.start();
      say(HEARTBEAT, FLIES, POSITION);
      awaitReadiness(flight, Readiness.READY);
      assertThat(flight.flight().position()).isNull();
      assertThat(flight.test("position").finding()).contains("set geoid_separation");
      flight.setParameter("geoid_separation", "-20");
      assertThat(flight.flight().position().height()).isEqualTo(42.5);
      flight.setParameter("geoid_separation", "told");
      assertThat(flight.flight().position()).isNull();
      assertThatThrownBy(() -> flight.setParameter("geoid_separation", "200"))
          .hasMessageContaining("cannot be \"200\", which is not a number from -120 to 100 m, or");
    }
  }

  @Test
  void losesAVehicleThatFallsSilentAndFindsItAgain() {
    try (MavlinkFlightImpl flight = new MavlinkFlightImpl(context("flight"), ticker, source)) {
      flight.start();
      say(HEARTBEAT, RECEIVER, FLIES, POSITION);
      awaitReadiness(flight, Readiness.READY);
      ticker.step(Duration.ofMillis(3100));
      awaitReadiness(flight, Readiness.INITIALIZING);
      assertThatThrownBy(flight::flight)
          .isInstanceOf(NotReadyException.class)
          .hasMessageContaining("no HEARTBEAT of an autopilot for 3 s");
      ticker.awaitWaiting();
      ticker.step(Duration.ofSeconds(1));
      await().until(() -> links.size() == 2);
      say(HEARTBEAT, POSITION);
      awaitReadiness(flight, Readiness.READY);
      assertThat(flight.flight().position().height()).isEqualTo(37.0); // the geoid is remembered
    }
  }

  @Test
  void passesOverOtherVehiclesAndCameras() {
    byte[] camera = HEARTBEAT.clone();
    camera[6] = 100;
    camera[15] = 8; // no autopilot
    byte[] other = HEARTBEAT.clone();
    other[5] = 2;
    try (MavlinkFlightImpl flight =
        new MavlinkFlightImpl(context("flight", "vehicle", "1"), ticker, source)) {
      flight.start();
      say(summed(camera, 50), summed(other, 50));
      say(HEARTBEAT, RECEIVER, FLIES, POSITION);
      awaitReadiness(flight, Readiness.READY);
      assertThat(parameter(flight, "autopilot")).isEqualTo("PX4 quadrotor, vehicle 1");
    }
  }

  @Test
  void sendsHeartbeatsOnlyWhileSomethingCommands() {
    try (MavlinkGpsImpl gps = new MavlinkGpsImpl(context("gps"), ticker, source)) {
      gps.start();
      say(HEARTBEAT, RECEIVER);
      awaitReadiness(gps, Readiness.READY);
      ticker.step(Duration.ofMillis(1500));
      await().until(() -> written(76) > 0); // asks for messages
      assertThat(written(0)).isZero();
      try (MavlinkFlightImpl flight = new MavlinkFlightImpl(context("flight"), ticker, source)) {
        flight.start();
        await().until(() -> written(0) == 1);
        ticker.step(Duration.ofMillis(1000));
        await().until(() -> written(0) == 2);
      }
      assertThat(links).hasSize(1); // one link for both
    }
  }

  @Test
  void tellsTheFixAsAReceiverOnTheGround() {
    try (MavlinkGpsImpl gps = new MavlinkGpsImpl(context("gps"), ticker, source)) {
      gps.start();
      say(HEARTBEAT, RECEIVER);
      awaitReadiness(gps, Readiness.READY);
      GpsFix fix = gps.fix();
      assertThat(fix.mode()).isEqualTo(GpsFix.Mode.FIX_3D);
      assertThat(fix.position().height()).isEqualTo(14.5);
      assertThat(fix.dilution()).isEqualTo(1.5);
      assertThat(fix.speed()).isEqualTo(5.0);
      assertThat(fix.course()).isEqualTo(306.87);
      assertThat(fix.utc()).isEqualTo(Instant.ofEpochSecond(1_769_000_000));
      assertThat(gps.time().utc()).isEqualTo(fix.utc());
      assertThat(parameter(gps, "accuracy")).isEqualTo("horizontal 1.50 m, vertical 2.50 m");
    }
  }

  @Test
  void saysThatTheReceiverHasLostItsPositionAndNotThatNothingComes() {
    byte[] blind = RECEIVER.clone();
    blind[10 + 28] = 1; // no fix
    blind[10 + 29] = 3; // satellites
    try (MavlinkGpsImpl gps = new MavlinkGpsImpl(context("gps"), ticker, source)) {
      gps.start();
      say(HEARTBEAT, RECEIVER);
      awaitReadiness(gps, Readiness.READY);
      for (int i = 0; i < 3; i++) {
        ticker.step(Duration.ofMillis(1900));
        say(HEARTBEAT, summed(blind, 24));
        awaitFrames(gps, 4 + 2 * i);
      }
      awaitReadiness(gps, Readiness.INITIALIZING);
      assertThatThrownBy(gps::fix)
          .hasMessageContaining("the receiver has no position, it uses 3 satellites");
    }
  }

  @Test
  void prefersTheBatteryItselfToTheSystemsStatus() {
    try (MavlinkBatteryImpl battery = new MavlinkBatteryImpl(context("battery"), ticker, source)) {
      battery.start();
      say(HEARTBEAT, SUPPLY);
      awaitReadiness(battery, Readiness.READY);
      assertThat(battery.battery().current()).isEqualTo(12.34);
      say(BATTERY);
      await().until(() -> battery.battery().current() == -1.5);
      assertThat(battery.battery().voltage()).isEqualTo(15.8);
      assertThat(battery.battery().remaining()).isEqualTo(0.63);
      awaitFrames(battery, 3); // a frame is counted after it is shown
      say(SUPPLY);
      awaitFrames(battery, 4);
      assertThat(battery.battery().current()).isEqualTo(-1.5);
    }
  }

  @Test
  void doesNotServeAReadingThatIsTooOld() {
    try (MavlinkBatteryImpl battery =
        new MavlinkBatteryImpl(context("battery", "period", "0.2"), ticker, source)) {
      battery.start();
      say(HEARTBEAT, BATTERY);
      awaitReadiness(battery, Readiness.READY);
      ticker.step(Duration.ofMillis(2000));
      say(HEARTBEAT);
      ticker.step(Duration.ofMillis(700));
      awaitReadiness(battery, Readiness.INITIALIZING);
      assertThatThrownBy(battery::battery)
          .isInstanceOf(NotReadyException.class)
          .hasMessageContaining("no BATTERY_STATUS for 2.6 s");
    }
  }

  @Test
  void refusesWrongParametersByName() {
    assertThatThrownBy(() -> new MavlinkFlightImpl(context("flight", "vehicle", "1.5")))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("vehicle")
        .hasMessageContaining("a whole number from 0 to 255");
    assertThatThrownBy(() -> new MavlinkFlightImpl(context("flight", "geoid_separation", "high")))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("geoid_separation");
    assertThatThrownBy(() -> new MavlinkGpsImpl(context("gps", "period", "0")))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("period");
    assertThatThrownBy(() -> new MavlinkBatteryImpl(context("battery", "battery", "256")))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("battery");
  }

  @Test
  void refusesToShareALinkWithOtherSettings() {
    try (MavlinkGpsImpl gps = new MavlinkGpsImpl(context("gps"), ticker, source);
        MavlinkBatteryImpl battery =
            new MavlinkBatteryImpl(context("battery", "vehicle", "7"), ticker, source)) {
      gps.start();
      assertThatThrownBy(battery::start)
          .isInstanceOf(IllegalStateException.class)
          .hasMessageContaining("uav/battery shares its link with uav/gps, but not its settings")
          .hasMessageEndingWith("write the same in both");
      assertThat(battery.readiness()).isEqualTo(Readiness.FAILED);
    }
  }

  /** Says it on the link that is open now, or will be. */
  private static void awaitFrames(ModuleImpl module, int all) {
    await().until(() -> parameter(module, "frames").equals(Integer.toString(all)));
  }

  private void say(byte[]... frames) {
    await().until(() -> !links.isEmpty());
    for (byte[] frame : frames) {
      links.get(links.size() - 1).say(frame);
    }
  }

  private long written(int message) {
    return links.stream()
        .flatMap(link -> link.written().stream())
        .filter(frame -> frame[7] == message && frame[8] == 0)
        .count();
  }

  private static byte[] summed(byte[] frame, int extra) {
    int sum = MavlinkFramer.checksum(frame, 1, frame.length - 2, extra);
    frame[frame.length - 2] = (byte) sum;
    frame[frame.length - 1] = (byte) (sum >> 8);
    return frame;
  }

  private static ModuleContext context(String name, String... parameters) {
    Map<String, String> all = texts("link", "tcp://uav:1");
    all.putAll(texts(parameters));
    return new ModuleContext("uav", name, Parameters.of("uav/" + name, all), Instant::now);
  }

  private static byte[] hex(String text) {
    return HexFormat.of().parseHex(text);
  }
}
