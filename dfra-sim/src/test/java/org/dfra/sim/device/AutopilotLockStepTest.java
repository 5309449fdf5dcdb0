package org.dfra.sim.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.function.BooleanSupplier;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.drivers.uav.mavlink.MavlinkBatteryImpl;
import org.dfra.drivers.uav.mavlink.MavlinkFlightImpl;
import org.dfra.drivers.uav.mavlink.MavlinkGpsImpl;
import org.dfra.event.DeliveryPolicy;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.FlightCommand;
import org.dfra.flow.effector.FlightCommand.Arm;
import org.dfra.flow.effector.FlightCommand.GoTo;
import org.dfra.flow.effector.FlightCommand.ReturnToLaunch;
import org.dfra.flow.effector.FlightCommand.TakeOff;
import org.dfra.flow.effector.FlightState.Phase;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.device.gps.AntennaTrajectory;
import org.dfra.sim.device.uav.AutopilotDevice;
import org.dfra.sim.device.uav.AutopilotSettings;
import org.dfra.sim.device.uav.AutopilotSettings.AutopilotSoftware;
import org.dfra.sim.physics.BatteryPhysics.Charge;
import org.dfra.sim.time.LockStep;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Three modules on one {@code sim:} link, step by step: a flight happens again as it happened. */
@Timeout(120)
class AutopilotLockStepTest {

  private static final Instant BEGIN = Instant.parse("2026-01-21T07:33:29Z");
  private static final GeoPosition DATUM = new GeoPosition(27.9506, -82.4572, 14.5);
  private static final Duration PATIENCE = Duration.ofMinutes(3);

  @ParameterizedTest
  @EnumSource
  void fliesTheSameFlightTwice(AutopilotSoftware software) throws Exception {
    String first = flown(software);
    assertThat(first).contains("phase=TAKING_OFF", "phase=LANDING", "GpsFix", "BatteryState");
    assertThat(flown(software)).isEqualTo(first);
  }

  /** Flies there and back while the cable is pulled for a while; returns all that was published. */
  private static String flown(AutopilotSoftware software) throws Exception {
    LockStep time = new LockStep(BEGIN);
    StringBuilder record = new StringBuilder();
    AutopilotDevice device =
        new AutopilotDevice(
            AutopilotSettings.of(software),
            DATUM,
            new Quad(),
            AntennaTrajectory.fixed(DATUM),
            when -> new Charge(15.8, 4.2, 0.87));
    try (SimPort port = new SimPort("autopilot", device, time);
        MavlinkFlightImpl flight = new MavlinkFlightImpl(context("flight", time, port));
        MavlinkGpsImpl gps = new MavlinkGpsImpl(context("gps", time, port));
        MavlinkBatteryImpl battery = new MavlinkBatteryImpl(context("battery", time, port))) {
      port.start();
      begin(flight, time, record);
      begin(gps, time, record);
      begin(battery, time, record);
      until(time, () -> flight.readiness().serves() && flight.flightState().position() != null);
      try (CommandLease lease = flight.acquireCommandLease(Duration.ofSeconds(30))) {
        execute(flight, lease, new Arm());
        until(time, () -> flight.flightState().isArmed());
        execute(flight, lease, new TakeOff(10));
        until(time, () -> flight.flightState().phase() == Phase.IN_AIR);
        GeoPosition there = new GeoPosition(27.9508, -82.4572, 30); // 22 m to the north
        execute(flight, lease, new GoTo(there, 5));
        until(time, () -> flight.flightState().position().groundDistance(there) < 0.1);
        port.cable().unplug();
        time.advance(Duration.ofMillis(2500));
        port.cable().restore();
        until(time, () -> flight.readiness().serves() && flight.flightState().position() != null);
        execute(flight, lease, new ReturnToLaunch());
        until(time, () -> !flight.flightState().isArmed());
      }
    }
    return record.toString();
  }

  private static void begin(ModuleImpl module, LockStep time, StringBuilder record) {
    var unused =
        module.subscribe(
            delivery ->
                record
                    .append(time.nanos())
                    .append(' ')
                    .append(module.identification().path())
                    .append(' ')
                    .append(delivery.event())
                    .append('\n'),
            DeliveryPolicy.keepLast(1000));
    module.start();
  }

  private static void execute(MavlinkFlightImpl flight, CommandLease lease, FlightCommand command) {
    flight.execute(lease.key(), command);
  }

  private static void until(LockStep time, BooleanSupplier reached) {
    assertThat(time.advanceUntil(reached, PATIENCE)).isTrue();
  }

  private static ModuleContext context(String name, LockStep time, SimPort port) {
    return new ModuleContext(
        "uav", name, Parameters.of("uav/" + name, Map.of("link", port.url())), time);
  }
}
