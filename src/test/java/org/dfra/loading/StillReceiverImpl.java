package org.dfra.loading;

import java.time.Instant;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.SensorImpl;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.LocationReading;
import org.dfra.flow.sensor.TimeReading;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;

/** A GPS receiver without a device, at 48.5 degrees north and 11.25 degrees east. */
public final class StillReceiverImpl extends SensorImpl implements GPSSensor {

  /** As every driver is made. */
  public StillReceiverImpl(ModuleContext context) {
    super(context, "a receiver without a device", "DFRA", "1");
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
    throw new UnsupportedOperationException("no test asks for it");
  }

  @Override
  public LocationReading location() {
    return new LocationReading(new GeoPosition(48.5, 11.25, 0), frame(), Instant.now());
  }

  @Override
  public TimeReading time() {
    return new TimeReading(Instant.now(), Instant.now());
  }
}
