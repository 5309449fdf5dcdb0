package org.dfra.drivers.uav.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.drivers.fixture.Modules.await;
import static org.dfra.drivers.fixture.Modules.awaitReadiness;
import static org.dfra.drivers.fixture.Modules.parameter;

import java.time.Duration;
import java.time.Instant;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.module.ModuleImpl;
import org.dfra.flow.effector.FlightState;
import org.dfra.flow.effector.FlightState.Phase;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.junit.jupiter.api.Test;

/** The modules on a link that says what the test has it say, on stepped time. */
class MavlinkModulesTest extends MavlinkFixture {

  @Test
  void putsTheStateOfAFlightTogether() {
    try (MavlinkFlightImpl flight = new MavlinkFlightImpl(context("flight"), ticker, source)) {
      flight.start();
      say(HEARTBEAT, RECEIVER, FLIES, POSITION);
      awaitReadiness(flight, Readiness.READY);
      FlightState state = flight.flightState();
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
  void hasNoPositionWhereItDoesNotKnowTheGeoidAndTakesASeparationThatIsSet() {
    try (MavlinkFlightImpl flight = new MavlinkFlightImpl(context("flight"), ticker, source)) {
      flight.start();
      say(HEARTBEAT, FLIES, POSITION);
      awaitReadiness(flight, Readiness.READY);
      assertThat(flight.flightState().position()).isNull();
      assertThat(flight.test("position").finding()).contains("set geoid_separation");
      flight.setParameter("geoid_separation", "-20");
      assertThat(flight.flightState().position().height()).isEqualTo(42.5);
      flight.setParameter("geoid_separation", "autopilot");
      assertThat(flight.flightState().position()).isNull();
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
      assertThatThrownBy(flight::flightState)
          .isInstanceOf(NotReadyException.class)
          .hasMessageContaining("no HEARTBEAT of an autopilot for 3 s");
      ticker.awaitWaiting();
      ticker.step(Duration.ofSeconds(1));
      await().until(() -> links.size() == 2);
      say(HEARTBEAT, POSITION);
      awaitReadiness(flight, Readiness.READY);
      assertThat(flight.flightState().position().height())
          .isEqualTo(37.0); // the geoid is remembered
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
  void reportsTheFixAsAReceiverOnTheGround() {
    try (MavlinkGpsImpl gps = new MavlinkGpsImpl(context("gps"), ticker, source)) {
      gps.start();
      say(HEARTBEAT, RECEIVER);
      awaitReadiness(gps, Readiness.READY);
      GpsFix fix = gps.fix();
      assertThat(fix.mode()).isEqualTo(GpsFix.Mode.FIX_3D);
      assertThat(fix.position().height()).isEqualTo(14.5);
      assertThat(fix.dilutionOfPrecision()).isEqualTo(1.5);
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

  /** Waits until the module has taken so many frames. */
  private static void awaitFrames(ModuleImpl module, int all) {
    await().until(() -> parameter(module, "frames").equals(Integer.toString(all)));
  }

  private long written(int message) {
    return links.stream()
        .flatMap(link -> link.written().stream())
        .filter(frame -> frame[7] == message && frame[8] == 0)
        .count();
  }
}
