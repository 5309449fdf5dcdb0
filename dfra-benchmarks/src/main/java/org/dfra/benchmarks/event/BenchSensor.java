package org.dfra.benchmarks.event;

import java.time.Instant;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.SensorImpl;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.LocationReading;
import org.dfra.flow.sensor.TimeReading;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.river.proxy.sensor.GPSProxy;
import org.dfra.river.server.ModuleServer;
import org.dfra.river.server.sensor.GPSServer;

/** A receiver that publishes a fix on request of the benchmark; served like any other receiver. */
public final class BenchSensor extends SensorImpl implements GPSSensor {

  /** Events per second. */
  public static final int RATE = 10;

  private static final GeoPosition PLACE = new GeoPosition(52, 7, 50);

  private static final BlockingQueue<BenchSensor> MADE = new LinkedBlockingQueue<>();

  private volatile Instant at = Instant.EPOCH;

  /** Called by the module's server, as for every driver. */
  public BenchSensor(ModuleContext context) {
    super(context, "a receiver of a benchmark", "DFRA", "1", List.of("GpsFix"), List.of());
    MADE.add(this);
  }

  /** The instance that a server has created by its class name. */
  public static BenchSensor awaitInstance() throws InterruptedException {
    return MADE.take();
  }

  /**
   * Serves an instance in this JVM, as a group would.
   *
   * @param locators of the lookup services that it joins; empty for none
   * @throws Exception if it cannot be served
   */
  public static GPSServer serve(List<String> locators) throws Exception {
    return ModuleServer.started(
        new GPSServer(
            null,
            BenchActivation.of(
                "gps", GPSServer.class, GPSProxy.class, BenchSensor.class, locators)));
  }

  @Override
  protected void onStart() {
    transitionTo(Readiness.READY);
  }

  @Override
  protected void onClose() {}

  /** Publishes a new fix to all listeners. */
  public void publish() {
    at = Instant.now();
    publish(fix());
  }

  @Override
  public double updateRate() {
    return RATE;
  }

  @Override
  public GpsFix fix() {
    return fix(at);
  }

  /** The fix that it publishes at a time. */
  static GpsFix fix(Instant at) {
    return new GpsFix(GpsFix.Mode.FIX_3D, PLACE, at, 0, 0, 1, 9, 9);
  }

  @Override
  public LocationReading location() {
    return new LocationReading(PLACE, frame(), at);
  }

  @Override
  public TimeReading time() {
    return new TimeReading(at, at);
  }
}
