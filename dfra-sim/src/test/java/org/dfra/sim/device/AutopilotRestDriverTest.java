package org.dfra.sim.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.dfra.sim.device.Modules.await;
import static org.dfra.sim.device.Modules.awaitPassed;
import static org.dfra.sim.device.Modules.parameter;

import java.time.Duration;
import org.dfra.drivers.uav.mavlink.MavlinkFlightImpl;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.FlightCommand.Arm;
import org.dfra.flow.effector.FlightCommand.GoTo;
import org.dfra.flow.effector.FlightCommand.Hold;
import org.dfra.flow.effector.FlightCommand.Land;
import org.dfra.flow.effector.FlightState;
import org.dfra.flow.effector.FlightState.Phase;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.sim.device.uav.AutopilotSettings.AutopilotSoftware;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What becomes of a vehicle without a commander, or without a ground station. */
@Execution(ExecutionMode.CONCURRENT) // flights take long, and little of the computer
class AutopilotRestDriverTest extends AutopilotOverTcp {

  @ParameterizedTest
  @EnumSource
  void holdsItsPositionWithoutACommanderAndExecutesCommandsOfTheNext(AutopilotSoftware software)
      throws Exception {
    begin(patientOf(software));
    try (MavlinkFlightImpl flight = flight()) {
      try (CommandLease lease = flight.acquireCommandLease(Duration.ofMinutes(10))) {
        takeOff(flight, lease, 10);
        execute(flight, lease, new GoTo(place(400, 0, 10), 4));
        await().until(() -> flight.flightState().speed() > 3);
      }
      await().until(() -> flight.flightState().speed() < 0.1);
      FlightState held = state(flight);
      assertThat(held.phase()).isEqualTo(Phase.IN_AIR);
      assertThat(held.height()).isCloseTo(10, within(0.6));
      assertThat(distance(held.position(), place(400, 0, 10))).isGreaterThan(100);
      try (CommandLease next = flight.acquireCommandLease(Duration.ofMinutes(10))) {
        GeoPosition there = place(0, 0, 12);
        execute(flight, next, new GoTo(there, 8));
        await().until(() -> distance(flight.flightState().position(), there) < 0.1);
      }
    }
  }

  @ParameterizedTest
  @EnumSource
  void isCommandedToHoldWhenTheModuleIsClosed(AutopilotSoftware software) throws Exception {
    begin(patientOf(software));
    try (MavlinkFlightImpl flight = flight()) {
      CommandLease lease = flight.acquireCommandLease(Duration.ofMinutes(10));
      takeOff(flight, lease, 10);
      execute(flight, lease, new GoTo(place(4000, 0, 10), 1));
      await().until(() -> flight.flightState().speed() > 0.5);
    }
    await().until(() -> quad.at(clock.instant()).eastward() == 0);
    assertThat(quad.at(clock.instant()).up()).isGreaterThan(9);
  }

  @ParameterizedTest
  @EnumSource
  void landsOnWhenItsCommanderLetsGoAfterTheOrder(AutopilotSoftware software) throws Exception {
    begin(patientOf(software));
    try (MavlinkFlightImpl flight = flight()) {
      try (CommandLease lease = flight.acquireCommandLease(Duration.ofMinutes(10))) {
        takeOff(flight, lease, 8);
        execute(flight, lease, new Land());
      }
      await().until(() -> !flight.flightState().isArmed());
      await().until(() -> flight.flightState().phase() == Phase.ON_GROUND); // by another message
    }
  }

  @ParameterizedTest
  @EnumSource
  void disarmsOnTheGroundWithoutACommander(AutopilotSoftware software) throws Exception {
    begin(patientOf(software));
    try (MavlinkFlightImpl flight = flight()) {
      try (CommandLease lease = flight.acquireCommandLease(Duration.ofMinutes(10))) {
        await().until(() -> flight.readiness().serves());
        execute(flight, lease, new Arm());
        await().until(() -> flight.flightState().isArmed());
      }
      await().until(() -> !flight.flightState().isArmed());
      assertThat(parameter(flight, "last_command")).startsWith("coming to rest");
    }
  }

  @ParameterizedTest
  @EnumSource
  void asksForRestUntilItIsGranted(AutopilotSoftware software) throws Exception {
    begin(patientOf(software));
    try (MavlinkFlightImpl flight = flight()) {
      try (CommandLease lease = flight.acquireCommandLease(Duration.ofMinutes(10))) {
        takeOff(flight, lease, 10);
        execute(flight, lease, new GoTo(place(2000, 0, 10), 2));
        await().until(() -> flight.flightState().speed() > 1);
        answers.put(MODE, 1);
      }
      await().until(() -> parameter(flight, "last_failure").contains("DO_SET_MODE"));
      answers.clear();
      await().until(() -> flight.flightState().speed() < 0.1);
      assertThat(parameter(flight, "last_command"))
          .isEqualTo("coming to rest: DO_SET_MODE is accepted");
    }
  }

  @ParameterizedTest
  @EnumSource
  void comesToRestWhenTheLinkIsBackThatWasLostBeforeItsCommander(AutopilotSoftware software)
      throws Exception {
    begin(patientOf(software));
    try (MavlinkFlightImpl flight = flight()) {
      try (CommandLease lease = flight.acquireCommandLease(Duration.ofMinutes(10))) {
        takeOff(flight, lease, 10);
        execute(flight, lease, new GoTo(place(4000, 0, 10), 1));
        await().until(() -> flight.flightState().speed() > 0.5);
        emulator.cable().unplug();
        await().until(() -> flight.readiness() == Readiness.INITIALIZING);
        assertThatThrownBy(() -> flight.execute(lease.key(), new Hold()))
            .isInstanceOf(NotReadyException.class);
      }
      emulator.cable().restore();
      await().until(() -> flight.readiness().serves());
      await().until(() -> flight.flightState().speed() < 0.1);
      assertThat(state(flight).phase()).isEqualTo(Phase.IN_AIR);
    }
  }

  @ParameterizedTest
  @EnumSource
  void leavesAVehicleAloneThatItHasNotCommanded(AutopilotSoftware software) throws Exception {
    begin(patientOf(software));
    try (MavlinkFlightImpl flight = flight()) {
      await().until(() -> flight.readiness().serves());
      flight.acquireCommandLease(Duration.ofMinutes(10)).close();
      awaitPassed(flight, "identification"); // an answer came after that
      assertThat(received).noneMatch(each -> each.command() == MODE || each.command() == ARM);
    }
  }

  @ParameterizedTest
  @EnumSource
  void returnsHomeByItselfWhenItMissesItsGroundStation(AutopilotSoftware software)
      throws Exception {
    begin(patientOf(software, Duration.ofSeconds(30)));
    try (MavlinkFlightImpl flight = flight();
        CommandLease lease = flight.acquireCommandLease(Duration.ofMinutes(10))) {
      takeOff(flight, lease, 10);
      execute(flight, lease, new GoTo(place(60, 0, 10), 8));
      await().until(() -> flight.flightState().position() != null && far(flight) > 30);
      emulator.cable().unplug();
      await().until(() -> quad.at(clock.instant()).up() == 0);
      emulator.cable().restore();
      await().until(() -> flight.readiness().serves());
      await().until(() -> !flight.flightState().isArmed());
      assertThat(far(flight)).isLessThan(1);
      assertThat(flight.history().failures()).isPositive();
    }
  }
}
