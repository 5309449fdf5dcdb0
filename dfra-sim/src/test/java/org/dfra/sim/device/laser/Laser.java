package org.dfra.sim.device.laser;

import static org.dfra.sim.device.Modules.await;

import java.io.IOException;
import java.time.InstantSource;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.laser.lms.LmsImpl;
import org.dfra.flow.sensor.RangeScan;
import org.dfra.sim.device.Cable;
import org.dfra.sim.device.DeviceEmulator;
import org.dfra.sim.physics.RangeInput;

/**
 * An emulated laser behind a cable that can be cut, by a clock that runs {@value #SPEED} times as
 * fast, so that waits of seconds take little time.
 */
public final class Laser implements AutoCloseable {

  public static final int SPEED = 3;

  /**
   * Sees 2 m to the right and 1 m more for each radian to the left, and nothing beyond 90° left.
   */
  public static final RangeInput SPIRAL =
      (time, first, step, longest, distances) -> {
        for (int i = 0; i < distances.length; i++) {
          double angle = first + i * step;
          distances[i] = angle > 1.5 ? Double.POSITIVE_INFINITY : distance(angle);
        }
      };

  private final InstantSource clock;
  private final LmsDevice device;
  private final DeviceEmulator emulator;

  public Laser(LmsEmulatorSettings makeup, InstantSource clock) throws IOException {
    this(makeup, clock, 0);
  }

  /** On this port. */
  public Laser(LmsEmulatorSettings makeup, InstantSource clock, int port) throws IOException {
    this.clock = clock;
    this.device = new LmsDevice(SPIRAL, makeup);
    this.emulator = new DeviceEmulator("laser", port, device, clock);
    emulator.start();
  }

  /** What the spiral is away in this direction, metres. */
  public static double distance(double angle) {
    return 2 + angle + Math.PI / 2;
  }

  public LmsDevice device() {
    return device;
  }

  public DeviceEmulator emulator() {
    return emulator;
  }

  public Cable cable() {
    return emulator.cable();
  }

  /** A driver of it that runs, with these parameters, name by name and value by value. */
  public LmsImpl driver(String... parameters) {
    LmsImpl driver = driverAt(emulator.url(), clock, parameters);
    driver.start();
    return driver;
  }

  /** A driver that does not run yet. */
  public static LmsImpl driverAt(String link, InstantSource clock, String... parameters) {
    Map<String, String> all = new HashMap<>(Map.of("link", link));
    for (int i = 0; i < parameters.length; i += 2) {
      all.put(parameters[i], parameters[i + 1]);
    }
    return new LmsImpl(
        new ModuleContext("atrv1", "laser", Parameters.of("atrv1/laser", all), clock));
  }

  /** The next scan that is served; a laser that rests is woken. */
  public static RangeScan scan(LmsImpl driver) {
    return await().until(driver::scan, Objects::nonNull);
  }

  @Override
  public void close() {
    emulator.close();
  }
}
