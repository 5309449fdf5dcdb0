package org.dfra.behaviors;

import java.util.List;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.SensorImpl;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.LocationReading;
import org.dfra.flow.sensor.Odometry;
import org.dfra.flow.sensor.OdometrySensor;
import org.dfra.flow.sensor.RangeScan;
import org.dfra.flow.sensor.RangeSensor;
import org.dfra.flow.sensor.TimeReading;
import org.dfra.lifecycle.Readiness;

/** Sensors that publish what the test has them publish. They are subscribed to, never polled. */
public final class ScriptedSensors {

  private ScriptedSensors() {}

  /** Base of all. */
  private abstract static class Scripted extends SensorImpl {

    private final double rate;

    Scripted(ModuleContext context, String description, String reading, double rate) {
      super(context, description, "DFRA", "1", List.of(reading), List.of());
      this.rate = rate;
    }

    @Override
    protected void onStart() {
      transitionTo(Readiness.READY);
    }

    @Override
    protected void onClose() {}

    @Override
    public double updateRate() {
      return rate;
    }

    static AssertionError asked() {
      return new AssertionError("it is listened to, not asked");
    }
  }

  /** Wheels that drive straight ahead. */
  public static final class Wheels extends Scripted implements OdometrySensor {

    public Wheels(ModuleContext context) {
      super(context, "wheels", "Odometry", 10);
    }

    /**
     * Tells how far they have come, now.
     *
     * @param metres since they began
     * @param speed metres per second, not negative
     */
    public void count(double metres, double speed) {
      publish(new Odometry(clock().instant(), "odom", "base_link", metres, 0, 0, speed, 0));
    }

    @Override
    public Odometry odometry() {
      throw asked();
    }
  }

  /** A laser at the front of the robot. */
  public static final class Laser extends Scripted implements RangeSensor {

    public Laser(ModuleContext context) {
      super(context, "a laser", "RangeScan", 10);
    }

    /** Publishes a scan of the half circle ahead, a beam a degree, measured now. */
    public void scan(float[] ranges) {
      publish(
          new RangeScan(
              clock().instant(),
              "laser",
              -Math.PI / 2,
              Math.toRadians(1),
              0,
              0.02,
              80,
              ranges.clone()));
    }

    @Override
    public RangeScan scan() {
      throw asked();
    }
  }

  /** A satellite receiver. */
  public static final class Receiver extends Scripted implements GPSSensor {

    public Receiver(ModuleContext context) {
      super(context, "a receiver", "GpsFix", 1);
    }

    /** Tells it. */
    public void solve(GpsFix fix) {
      publish(fix);
    }

    @Override
    public GpsFix fix() {
      throw asked();
    }

    @Override
    public LocationReading location() {
      throw asked();
    }

    @Override
    public TimeReading time() {
      throw asked();
    }
  }
}
