package org.dfra.sim.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;
import static org.assertj.core.api.Assertions.within;
import static org.dfra.sim.device.Modules.await;
import static org.dfra.sim.device.Modules.awaitNoLink;
import static org.dfra.sim.device.Modules.awaitPassed;
import static org.dfra.sim.device.Modules.awaitRecovered;
import static org.dfra.sim.device.Modules.number;
import static org.dfra.sim.device.Modules.parameter;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Random;
import java.util.concurrent.CopyOnWriteArrayList;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.dfra.drivers.uav.mavlink.MavlinkBatteryImpl;
import org.dfra.drivers.uav.mavlink.MavlinkFlightImpl;
import org.dfra.drivers.uav.mavlink.MavlinkGpsImpl;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent.IncidentRecorded;
import org.dfra.event.Subscription;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.FlightCommand.Arm;
import org.dfra.flow.effector.FlightCommand.Disarm;
import org.dfra.flow.effector.FlightCommand.GoTo;
import org.dfra.flow.effector.FlightCommand.Hold;
import org.dfra.flow.effector.FlightCommand.Land;
import org.dfra.flow.effector.FlightCommand.ReturnToLaunch;
import org.dfra.flow.effector.FlightCommand.TakeOff;
import org.dfra.flow.effector.FlightState;
import org.dfra.flow.effector.FlightState.Phase;
import org.dfra.flow.sensor.BatteryState;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.persona.FlightAttributes;
import org.dfra.sim.device.uav.AutopilotSettings.AutopilotSoftware;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What the drivers do while the vehicle has a commander, and their diagnostics. */
@Execution(ExecutionMode.CONCURRENT) // flights take long, and little of the computer
class AutopilotDriverTest extends AutopilotOverTcp {

  /** Of MAVLink 2, signed, bytes. */
  private static final long LONGEST_FRAME = 280;

  @ParameterizedTest
  @EnumSource
  void fliesToThePlaceThatIsCommandedAndComesHome(AutopilotSoftware software) throws Exception {
    begin(patientOf(software));
    try (MavlinkFlightImpl flight = flight();
        CommandLease lease = flight.acquireCommandLease(Duration.ofMinutes(10))) {
      takeOff(flight, lease, 10);
      assertThat(state(flight).height()).isCloseTo(10, within(0.6));
      assertThat(state(flight).position().height()).isCloseTo(24.5, within(0.6));

      GeoPosition there = place(24, 18, 15);
      execute(flight, lease, new GoTo(there, 6));
      await().until(() -> distance(flight.flightState().position(), there) < 0.1);
      await().until(() -> flight.flightState().speed() < 0.1);
      await().until(() -> Math.abs(flight.flightState().height() - 15) < 0.05);
      FlightState state = state(flight);
      assertThat(state.phase()).isEqualTo(Phase.IN_AIR);
      assertThat(state.isArmed()).isTrue();

      execute(flight, lease, new ReturnToLaunch());
      await().until(() -> flight.flightState().phase() == Phase.LANDING);
      await().until(() -> !flight.flightState().isArmed());
      await().until(() -> flight.flightState().phase() == Phase.ON_GROUND); // by another message
      assertThat(distance(state(flight).position(), place(0, 0, 0))).isLessThan(0.6);
      assertThat(parameter(flight, "last_failure")).isEqualTo("none");
      // Where the link was opened again, the frames that this cut were dropped.
      assertThat(number(flight, "dropped_bytes"))
          .isLessThanOrEqualTo(2 * LONGEST_FRAME * flight.history().failures());
      assertThat(parameter(flight, "malformed_frames")).isEqualTo("0");
    }
  }

  @ParameterizedTest
  @EnumSource
  void reportsWhyTheVehicleRefuses(AutopilotSoftware software) throws Exception {
    begin(patientOf(software).withTimeToFirstFix(Duration.ofSeconds(12)));
    List<String> incidents = new CopyOnWriteArrayList<>();
    try (MavlinkFlightImpl flight = flight();
        Subscription unused =
            flight.subscribe(
                delivery -> {
                  if (delivery.event() instanceof IncidentRecorded noted) {
                    incidents.add(noted.incident().description());
                  }
                },
                DeliveryPolicy.keepLast(100));
        CommandLease lease = flight.acquireCommandLease(Duration.ofMinutes(10))) {
      answers.put(ARM, 1);
      await().until(() -> flight.readiness().serves());
      await().until(() -> flight.flightState().position() != null);
      execute(flight, lease, new Arm());
      await().until(() -> parameter(flight, "last_failure").contains("rejected for now"));
      assertThat(parameter(flight, "last_failure"))
          .startsWith("uav/flight did not execute Arm: COMPONENT_ARM_DISARM is rejected for now")
          .endsWith("give the command again in a while");
      assertThat(parameter(flight, "last_command")).startsWith("Arm: COMPONENT_ARM_DISARM");
      await().until(() -> incidents.contains(parameter(flight, "last_failure")));
      assertThat(state(flight).isArmed()).isFalse();
      answers.clear();
      execute(flight, lease, new Arm());
      await().until(() -> flight.flightState().isArmed());
    }
  }

  @ParameterizedTest
  @EnumSource
  void passesOnWhatTheAutopilotSaidOfIt(AutopilotSoftware software) throws Exception {
    begin(patientOf(software));
    try (MavlinkFlightImpl flight = flight();
        CommandLease lease = flight.acquireCommandLease(Duration.ofMinutes(10))) {
      takeOff(flight, lease, 5);
      execute(flight, lease, new GoTo(place(9000, 0, 5), 5));
      await().until(() -> parameter(flight, "last_text").contains("outside the fence"));
      await().until(() -> parameter(flight, "last_failure").contains("denied"));
      assertThat(parameter(flight, "last_failure")).contains("GoTo: DO_REPOSITION is denied");
    }
  }

  @ParameterizedTest
  @EnumSource
  void sendsAgainWhatIsNotAnsweredAndCountsIt(AutopilotSoftware software) throws Exception {
    begin(patientOf(software));
    try (MavlinkFlightImpl flight = flight();
        CommandLease lease = flight.acquireCommandLease(Duration.ofMinutes(10))) {
      await().until(() -> flight.readiness().serves());
      deafTo = ARM;
      execute(flight, lease, new Arm());
      await().until(() -> confirmations(ARM).size() >= 2);
      deafTo = -1;
      await().until(() -> flight.flightState().isArmed());
      List<Integer> confirmations = confirmations(ARM);
      for (int i = 0; i < confirmations.size(); i++) {
        assertThat(confirmations.get(i)).isEqualTo(i);
      }
    }
  }

  @ParameterizedTest
  @EnumSource
  void saysWhatIsNeverAnswered(AutopilotSoftware software) throws Exception {
    begin(patientOf(software));
    try (MavlinkFlightImpl flight = flight();
        CommandLease lease = flight.acquireCommandLease(Duration.ofMinutes(10))) {
      takeOff(flight, lease, 5);
      deafTo = LAND;
      execute(flight, lease, new Land());
      await().until(() -> parameter(flight, "last_failure").contains("is not answered"));
      assertThat(parameter(flight, "last_failure"))
          .startsWith("uav/flight did not execute Land: NAV_LAND was sent 4 times")
          .contains("check with flight() whether it was executed");
      assertThat(confirmations(LAND)).containsExactly(0, 1, 2, 3);
    }
  }

  @ParameterizedTest
  @EnumSource
  void refusesAtOnceWhatCannotBe(AutopilotSoftware software) throws Exception {
    begin(patientOf(software));
    try (MavlinkFlightImpl flight = flight();
        CommandLease lease = flight.acquireCommandLease(Duration.ofMinutes(10))) {
      await().until(() -> flight.readiness().serves());
      await().until(() -> flight.flightState().position() != null);
      refuses(
          () -> flight.execute(lease.key(), new GoTo(place(1, 1, 5), 1)),
          "is on the ground; command a take-off first");
      refuses(
          () -> flight.execute(lease.key(), new TakeOff(121)),
          "height 121.0 m above the place of take-off > max_height 120.0 m");
      takeOff(flight, lease, 5);
      refuses(() -> flight.execute(lease.key(), new Disarm()), "motors are not stopped in the air");
      refuses(() -> flight.execute(lease.key(), new TakeOff(5)), "flies already");
      flight.setParameter("max_height", "20");
      refuses(
          () -> flight.execute(lease.key(), new GoTo(place(1, 1, 21), 1)), "height 21.0 m above");
      assertThat(state(flight).phase()).isEqualTo(Phase.IN_AIR);
    }
  }

  @ParameterizedTest
  @EnumSource
  void neverRepeatsAnOrderAfterTheNext(AutopilotSoftware software) throws Exception {
    begin(patientOf(software));
    try (MavlinkFlightImpl flight = flight();
        CommandLease lease = flight.acquireCommandLease(Duration.ofMinutes(10))) {
      takeOff(flight, lease, 10);
      deafTo = REPOSITION;
      execute(flight, lease, new GoTo(place(400, 0, 10), 4));
      await().until(() -> !confirmations(REPOSITION).isEmpty());
      execute(flight, lease, new Hold());
      await()
          .until(() -> parameter(flight, "last_command").equals("Hold: DO_SET_MODE is accepted"));
      int before = confirmations(REPOSITION).size();
      deafTo = -1;
      execute(flight, lease, new Land()); // takes its time, in which a repetition would come
      await().until(() -> !flight.flightState().isArmed());
      assertThat(confirmations(REPOSITION)).hasSize(before);
    }
  }

  @ParameterizedTest
  @EnumSource
  void sharesItsLinkWithTheSensorsBehindIt(AutopilotSoftware software) throws Exception {
    begin(patientOf(software));
    MavlinkFlightImpl flight = flight();
    MavlinkGpsImpl gps = new MavlinkGpsImpl(context("gps", Map.of()));
    MavlinkBatteryImpl battery =
        new MavlinkBatteryImpl(context("battery", Map.of("period", "0.5")));
    try (flight;
        gps;
        battery) {
      gps.start();
      battery.start();
      await().until(() -> gps.readiness().serves());
      await().until(() -> battery.readiness().serves());

      GpsFix fix = await().until(gps::fix, Objects::nonNull);
      assertThat(fix.mode()).isEqualTo(GpsFix.Mode.FIX_3D);
      assertThat(distance(fix.position(), DATUM)).isLessThan(0.02);
      assertThat(fix.position().height()).isCloseTo(14.5, within(0.002));
      assertThat(fix.dilutionOfPrecision()).isCloseTo(1.5, within(1e-6)); // of 0.9 and 1.2
      assertThat(fix.satellitesTracked()).isEqualTo(11);
      await().until(() -> gps.time() != null); // SYSTEM_TIME comes later
      await()
          .untilAsserted(
              () ->
                  assertThat(Duration.between(gps.time().utc(), clock.instant()).abs())
                      .isLessThan(Duration.ofSeconds(20)));
      assertThat(gps.location().frame()).isEqualTo("uav/gps");

      BatteryState charge = await().until(battery::battery, Objects::nonNull);
      assertThat(charge.voltage()).isCloseTo(15.8, within(0.01));
      assertThat(charge.current()).isCloseTo(4.2, within(0.01));
      assertThat(charge.remaining()).isCloseTo(0.87, within(0.001));
      assertThat(charge.isEstimated()).isFalse();
      awaitPassed(gps);
      awaitPassed(battery);

      flight.close();
      long frames = number(gps, "frames");
      await().until(() -> number(gps, "frames") > frames + 5);
      await().until(() -> gps.readiness().serves());
    }
  }

  @ParameterizedTest
  @EnumSource
  void examinesItself(AutopilotSoftware software) throws Exception {
    begin(patientOf(software));
    try (MavlinkFlightImpl flight = flight()) {
      await().until(() -> flight.readiness().serves());
      await().until(() -> flight.flightState().position() != null);
      assertThat(flight.tests()).containsExactly("link", "identification", "readings", "position");
      awaitPassed(flight);
      assertThat(awaitPassed(flight, "identification").finding())
          .contains(software == AutopilotSoftware.PX4 ? "PX4 quadrotor" : "ArduPilot quadrotor")
          .contains(software == AutopilotSoftware.PX4 ? "1.15.4" : "4.6.0");
      assertThat(flight.attributes()).hasAtLeastOneElementOfType(FlightAttributes.class);
      awaitRecovered(flight, "reopen_link");
      await().until(() -> flight.readiness().serves());
      emulator.cable().unplug();
      await().until(() -> flight.readiness() == Readiness.INITIALIZING);
      awaitNoLink(flight, "link");
      assertThat(flight.test("identification").passed()).isFalse();
      assertThat(flight.test("position").passed()).isFalse();
      emulator.cable().restore();
      await().until(() -> flight.readiness().serves());
    }
  }

  @ParameterizedTest
  @EnumSource
  void goesOnThroughSilenceAndGarbage(AutopilotSoftware software) throws Exception {
    begin(patientOf(software));
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    emulator.cable().injectNoiseBursts(seed);
    try (MavlinkFlightImpl flight = flight()) {
      await("-Ddfra.seed=" + seed).until(() -> number(flight, "dropped_bytes") > 10_000);
      emulator.cable().restore();
      await("-Ddfra.seed=" + seed).until(() -> flight.readiness().serves());
      emulator.cable().mute();
      await("-Ddfra.seed=" + seed).until(() -> flight.readiness() == Readiness.INITIALIZING);
      assertThatThrownBy(flight::flightState)
          .as("-Ddfra.seed=%d", seed)
          .isInstanceOf(NotReadyException.class)
          .hasMessageContaining("HEARTBEAT of an autopilot");
      emulator.cable().restore();
      await("-Ddfra.seed=" + seed).until(() -> flight.readiness().serves());
    }
  }

  private static void refuses(ThrowingCallable call, String why) {
    Throwable refusal =
        await().until(() -> catchThrowable(call), each -> !(each instanceof NotReadyException));
    assertThat(refusal).isInstanceOf(IllegalArgumentException.class).hasMessageContaining(why);
  }
}
