package org.dfra.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.sim.device.Modules.await;

import java.time.Duration;
import java.time.InstantSource;
import java.util.Map;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.state.StateStore;
import org.dfra.drivers.uav.mavlink.MavlinkFlightImpl;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.FlightCommand.Arm;
import org.dfra.flow.effector.FlightCommand.GoTo;
import org.dfra.flow.effector.FlightCommand.ReturnToLaunch;
import org.dfra.flow.effector.FlightCommand.TakeOff;
import org.dfra.flow.effector.FlightState.Phase;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalPosition;
import org.dfra.sim.device.DeviceEmulator;
import org.dfra.sim.device.Modules;
import org.dfra.sim.device.uav.AutopilotDevice;
import org.dfra.sim.device.uav.AutopilotSettings;
import org.dfra.sim.device.uav.AutopilotSettings.AutopilotSoftware;
import org.dfra.sim.physics.MulticopterPhysics;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.dfra.time.Scheduler;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The driver, the emulated autopilot, and the world's own multicopter under it. */
@Timeout(240)
@Execution(ExecutionMode.CONCURRENT) // flights take long, and little of the computer
class AutopilotInTheWorldTest {

  private static final int SPEED = 4; // times as fast as the computer's time

  @ParameterizedTest
  @EnumSource
  void fliesAboveTheFieldAndComesHome(AutopilotSoftware software) throws Exception {
    long begin = System.nanoTime();
    InstantSource clock = () -> Worlds.START.plusNanos((System.nanoTime() - begin) * SPEED);
    World world =
        World.of(
            Worlds.field(7)
                .with(
                    new VehicleDescription("uav", VehicleType.UAV, 30, 20, 0)
                        .with(Worlds.device(DeviceKind.FLIGHT, "flight"))
                        .with(Worlds.device(DeviceKind.GPS, "gps"))
                        .with(Worlds.device(DeviceKind.BATTERY, "battery"))),
            Worlds.START);
    SimulatedRobot robot = world.robot("uav");
    MulticopterPhysics body = robot.multicopter("flight");
    AutopilotDevice autopilot =
        new AutopilotDevice(
            AutopilotSettings.of(software),
            world.frame().datum(),
            body,
            robot.antenna("gps"),
            robot.battery("battery"));
    try (DeviceEmulator emulator = new DeviceEmulator("autopilot", 0, autopilot, clock)) {
      emulator.start();
      try (MavlinkFlightImpl flight = driver(emulator.url(), clock);
          CommandLease lease = flight.acquireCommandLease(Duration.ofMinutes(10))) {
        await().until(() -> flight.readiness().serves());
        await().until(() -> flight.flightState().position() != null);
        flight.execute(lease.key(), new Arm());
        await().until(() -> flight.flightState().isArmed());
        flight.execute(lease.key(), new TakeOff(8));
        await().until(() -> flight.flightState().phase() == Phase.IN_AIR);

        GeoPosition there = world.frame().toGeo(new LocalPosition(45, 32, 12));
        flight.execute(lease.key(), new GoTo(there, 5));
        await().until(() -> off(body.at(clock.instant()), 45, 32, 12) < 0.5);

        flight.execute(lease.key(), new ReturnToLaunch());
        await().until(() -> !flight.flightState().isArmed());
        assertThat(off(body.at(clock.instant()), 30, 20, 0)).isLessThan(1.5);
        assertThat(body.at(clock.instant()).rotorsTurning()).isFalse();
      }
    }
  }

  private static double off(
      MulticopterPhysics.MulticopterState at, double east, double north, double up) {
    return Math.hypot(Math.hypot(at.east() - east, at.north() - north), at.up() - up);
  }

  private static MavlinkFlightImpl driver(String link, InstantSource clock) {
    MavlinkFlightImpl flight =
        new MavlinkFlightImpl(
            new ModuleContext(
                "uav",
                "flight",
                Parameters.of("uav/flight", Map.of("link", link)),
                clock,
                StateStore.inMemory(),
                Modules.LONG_LEASES,
                Scheduler.system()));
    flight.start();
    return flight;
  }
}
