package org.dfra.sim.device;

import static org.dfra.sim.device.Modules.await;

import java.io.IOException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.state.StateStore;
import org.dfra.drivers.uav.mavlink.MavlinkFlightImpl;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.FlightCommand;
import org.dfra.flow.effector.FlightCommand.Arm;
import org.dfra.flow.effector.FlightCommand.TakeOff;
import org.dfra.flow.effector.FlightState;
import org.dfra.flow.effector.FlightState.Phase;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.sim.device.gps.AntennaTrajectory;
import org.dfra.sim.device.uav.AutopilotDevice;
import org.dfra.sim.device.uav.AutopilotSettings;
import org.dfra.sim.device.uav.AutopilotSettings.AutopilotSoftware;
import org.dfra.sim.physics.BatteryPhysics.Charge;
import org.dfra.time.Scheduler;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Timeout;

/** The drivers of an unmanned aerial vehicle with its emulated autopilot, over TCP. */
@Timeout(240)
abstract class AutopilotOverTcp {

  /** Forty metres above sea, where the geoid is 25.5 m below the ellipsoid. */
  static final GeoPosition DATUM = new GeoPosition(27.9506, -82.4572, 14.5);

  static final LocalFrame WORLD = new LocalFrame(DATUM);
  static final int ARM = 400;

  /** Longer than it takes to report that it is armed, and shorter than it stays so. */
  private static final Duration ARMING = Duration.ofMillis(500);

  static final int LAND = 21;
  static final int MODE = 176;
  static final int REPOSITION = 192;

  /** A command that the vehicle received, and how often it was sent before. */
  record ReceivedCommand(int command, int confirmation) {}

  final InstantSource clock = FastClock.of(4);
  final Quad quad = new Quad();
  final List<ReceivedCommand> received = new CopyOnWriteArrayList<>();
  final Map<Integer, Integer> answers = new ConcurrentHashMap<>();
  volatile int deafTo = -1;
  DeviceEmulator emulator;

  @AfterEach
  void end() throws IOException {
    emulator.close();
  }

  void takeOff(MavlinkFlightImpl flight, CommandLease lease, double height) {
    await().until(() -> flight.readiness().serves());
    await().until(() -> flight.flightState().position() != null);
    arm(flight, lease);
    execute(flight, lease, new TakeOff(height));
    await().until(() -> flight.flightState().height() > height - 0.6);
    await().until(() -> flight.flightState().phase() == Phase.IN_AIR);
  }

  /**
   * Arms it, again where it has disarmed: it does so after ten seconds on the ground, which pass by
   * this fast clock while the computer stalls for 2.5 s.
   */
  private static void arm(MavlinkFlightImpl flight, CommandLease lease) {
    await()
        .pollDelay(Duration.ZERO)
        .pollInterval(ARMING)
        .until(
            () -> {
              boolean isArmed = flight.flightState().isArmed();
              if (!isArmed) {
                execute(flight, lease, new Arm());
              }
              return isArmed;
            });
  }

  /**
   * Sends a command, again where the vehicle was lost for a moment: a stall of the computer of 0.75
   * s is a timeout by this fast clock.
   */
  static void execute(MavlinkFlightImpl flight, CommandLease lease, FlightCommand command) {
    await()
        .until(
            () -> {
              flight.execute(lease.key(), command);
              return true;
            });
  }

  /** How it flies, as soon as that is known. */
  static FlightState state(MavlinkFlightImpl flight) {
    return await().until(flight::flightState, Objects::nonNull);
  }

  void begin(AutopilotSettings settings) throws IOException {
    AutopilotDevice device =
        new AutopilotDevice(
            settings.with(this::answer),
            DATUM,
            quad,
            AntennaTrajectory.fixed(DATUM),
            time -> new Charge(15.8, 4.2, 0.87));
    emulator = new DeviceEmulator("autopilot", 0, device, clock);
    emulator.start();
  }

  Integer answer(int command, int confirmation) {
    received.add(new ReceivedCommand(command, confirmation));
    return command == deafTo
        ? Integer.valueOf(AutopilotSettings.CommandFaults.NO_ANSWER)
        : answers.get(command);
  }

  List<Integer> confirmations(int command) {
    return received.stream()
        .filter(each -> each.command() == command)
        .map(ReceivedCommand::confirmation)
        .toList();
  }

  MavlinkFlightImpl flight() {
    MavlinkFlightImpl flight = new MavlinkFlightImpl(context("flight", Map.of()));
    flight.start();
    return flight;
  }

  ModuleContext context(String name, Map<String, String> parameters) {
    Map<String, String> all = new HashMap<>(parameters);
    all.put("link", emulator.url());
    return new ModuleContext(
        "uav",
        name,
        Parameters.of("uav/" + name, all),
        clock,
        StateStore.inMemory(),
        Modules.LONG_LEASES,
        Scheduler.system());
  }

  /** One that does not lose its ground station, also where the computer stalls. */
  static AutopilotSettings patientOf(AutopilotSoftware software) {
    return patientOf(software, Duration.ofHours(1));
  }

  /** One that misses its ground station after so long. */
  static AutopilotSettings patientOf(AutopilotSoftware software, Duration missesStationAfter) {
    AutopilotSettings usual = AutopilotSettings.of(software);
    return new AutopilotSettings(
        software,
        usual.vehicle(),
        usual.baud(),
        usual.separation(),
        usual.timeToFirstFix(),
        missesStationAfter,
        usual.returnDelay(),
        usual.returnHeight(),
        usual.commandFaults());
  }

  static double far(MavlinkFlightImpl flight) {
    return state(flight).position().groundDistance(DATUM);
  }

  /** Metres, heights included. */
  static double distance(GeoPosition a, GeoPosition b) {
    LocalPosition at = WORLD.toLocal(a);
    LocalPosition to = WORLD.toLocal(b);
    return Math.hypot(
        Math.hypot(at.east() - to.east(), at.north() - to.north()), at.up() - to.up());
  }

  /** A place by metres from the datum. */
  static GeoPosition place(double east, double north, double up) {
    return WORLD.toGeo(new LocalPosition(east, north, up));
  }
}
