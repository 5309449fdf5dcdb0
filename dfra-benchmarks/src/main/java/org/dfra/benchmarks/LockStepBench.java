package org.dfra.benchmarks;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.DeviceImpl;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.gps.gpsd.GpsdImpl;
import org.dfra.drivers.gps.m12.M12PlusImpl;
import org.dfra.drivers.gps.nmea.NmeaImpl;
import org.dfra.drivers.gps.ubx.UbxImpl;
import org.dfra.drivers.laser.lms.LmsImpl;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.device.SerialDevice;
import org.dfra.sim.device.SimPort;
import org.dfra.sim.device.gps.AntennaTrajectory;
import org.dfra.sim.device.gps.GpsdDevice;
import org.dfra.sim.device.gps.M12Device;
import org.dfra.sim.device.gps.NmeaDevice;
import org.dfra.sim.device.gps.UbxDevice;
import org.dfra.sim.device.laser.LmsDevice;
import org.dfra.sim.device.laser.LmsEmulatorSettings;
import org.dfra.sim.physics.RangeInput;
import org.dfra.sim.time.LockStep;

/**
 * Measures how much faster than real time a robot's drivers run in lock-step: an hour of one
 * receiver, of one device of each kind, and of a laser. The limit is a hundredth of real time.
 */
final class LockStepBench implements Bench {

  private static final Instant BEGIN = Instant.parse("2026-01-21T07:33:29Z");
  private static final Duration WARM_UP = Duration.ofMinutes(10);
  private static final Duration HOUR = Duration.ofHours(1);
  private static final double MOST_SECONDS = 36;

  private static final AntennaTrajectory PATH =
      AntennaTrajectory.constantVelocity(
          new GeoPosition(52.910313611, 6.866706667, 55.91), BEGIN, 0.6, 0.8);

  private record SimulatedDriver(
      String name, SerialDevice device, Function<ModuleContext, ? extends DeviceImpl> driver) {}

  @Override
  public void run(Report report) {
    measure(report, "one receiver", List.of(m12()));
    measure(
        report,
        "four receivers",
        List.of(
            m12(),
            new SimulatedDriver("nmea", new NmeaDevice(PATH, 4800, Duration.ZERO), NmeaImpl::new),
            new SimulatedDriver("ubx", new UbxDevice(PATH, 38_400, Duration.ZERO), UbxImpl::new),
            new SimulatedDriver(
                "gpsd", new GpsdDevice(PATH, 115_200, Duration.ZERO), GpsdImpl::new)));
    RangeInput wall = (time, first, step, longest, distances) -> Arrays.fill(distances, 3);
    LmsEmulatorSettings fast = LmsEmulatorSettings.factoryDefault().withBaud(500_000);
    measure(
        report,
        "a laser at 37.5 Hz",
        List.of(new SimulatedDriver("laser", new LmsDevice(wall, fast), LmsImpl::new)));
  }

  private static SimulatedDriver m12() {
    return new SimulatedDriver("m12", new M12Device(PATH, 9600, Duration.ZERO), M12PlusImpl::new);
  }

  private static void measure(Report report, String what, List<SimulatedDriver> units) {
    LockStep time = new LockStep(BEGIN);
    List<AutoCloseable> open = new ArrayList<>();
    try {
      List<DeviceImpl> drivers = new ArrayList<>();
      for (SimulatedDriver each : units) {
        SimPort port = new SimPort(each.name(), each.device(), time);
        open.add(port);
        port.start();
        DeviceImpl driver = each.driver().apply(context(each.name(), port.url(), time));
        open.add(driver);
        drivers.add(driver);
        driver.start();
      }
      time.advance(WARM_UP);
      long began = System.nanoTime();
      time.advance(HOUR);
      double seconds = (System.nanoTime() - began) / 1e9;
      drivers.forEach(LockStepBench::requireWork);
      report.figure("an hour of " + what, seconds, MOST_SECONDS, "s");
      report.figure("simulated over real time, " + what, HOUR.toSeconds() / seconds, "times");
    } finally {
      open.forEach(LockStepBench::close);
    }
  }

  private static ModuleContext context(String name, String link, LockStep time) {
    return new ModuleContext(
        "bench",
        name,
        Parameters.of("bench/" + name, Map.of("link", link, "idle_timeout", "0")),
        time);
  }

  /** Checks that the measured device worked. */
  private static void requireWork(DeviceImpl driver) {
    if (!driver.readiness().serves() || driver.history().failures() > 0) {
      throw new IllegalStateException(
          "the hour was of no use: " + driver + " is " + driver.readiness() + driver.history());
    }
  }

  private static void close(AutoCloseable each) {
    try {
      each.close();
    } catch (Exception e) { // declared by AutoCloseable; neither ports nor drivers throw it
      throw new IllegalStateException(e);
    }
  }
}
