package org.dfra.benchmarks.scale;

import java.time.Instant;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.SensorImpl;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.LocationReading;
import org.dfra.flow.sensor.TimeReading;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;

/** A receiver without a device, which costs a robot nothing but what every module costs. */
public final class LightSensor extends SensorImpl implements GPSSensor {

  private static final GeoPosition PLACE = new GeoPosition(52, 7, 50);

  /** All of this process, in the order of construction. */
  private static final List<LightSensor> ALL = new CopyOnWriteArrayList<>();

  /** Called by the module's server, as for every driver. */
  public LightSensor(ModuleContext context) {
    super(context, "a receiver of a benchmark", "DFRA", "1", List.of("GpsFix"), List.of());
    ALL.add(this);
  }

  /** All of this process, in the order of construction. */
  static List<LightSensor> all() {
    return List.copyOf(ALL);
  }

  /** Pauses, or resumes if it is paused: a change that its lookup attributes show. */
  void toggle() {
    transitionTo(readiness() == Readiness.PAUSED ? Readiness.READY : Readiness.PAUSED);
  }

  @Override
  protected void onStart() {
    transitionTo(Readiness.READY);
  }

  @Override
  protected void onClose() {}

  @Override
  public double updateRate() {
    return 1;
  }

  @Override
  public GpsFix fix() {
    return new GpsFix(GpsFix.Mode.FIX_3D, PLACE, Instant.EPOCH, 0, 0, 1, 9, 9);
  }

  @Override
  public LocationReading location() {
    return new LocationReading(PLACE, frame(), Instant.EPOCH);
  }

  @Override
  public TimeReading time() {
    return new TimeReading(Instant.EPOCH, Instant.EPOCH);
  }
}
