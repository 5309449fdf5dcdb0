package org.dfra.autonomy;

import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import org.dfra.core.effector.DriveImpl;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.SensorImpl;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.LocationReading;
import org.dfra.flow.sensor.Odometry;
import org.dfra.flow.sensor.OdometrySensor;
import org.dfra.flow.sensor.RangeScan;
import org.dfra.flow.sensor.RangeSensor;
import org.dfra.flow.sensor.TimeReading;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.DriveAttributes;
import org.dfra.time.Scheduler;

/**
 * Drivers of a robot that has no devices: its body goes where its wheels turn, in real time, on an
 * empty field. There is one such body in a virtual machine.
 */
final class SmallRobot {

  static final GeoPosition DATUM = new GeoPosition(48, 11, 0);

  private static final LocalFrame FRAME = new LocalFrame(DATUM);
  private static final Body BODY = new Body();

  private SmallRobot() {}

  /** Where it stands, and how its wheels turn. */
  private static final class Body {
    private double east; // guarded by this
    private double north; // guarded by this
    private double yaw; // guarded by this
    private Velocity velocity = Velocity.ZERO; // guarded by this

    synchronized void turn(Velocity wanted) {
      velocity = wanted;
    }

    synchronized Odometry move(double seconds) {
      yaw += velocity.yawRate() * seconds;
      east += velocity.speed() * Math.cos(yaw) * seconds;
      north += velocity.speed() * Math.sin(yaw) * seconds;
      return new Odometry(
          Instant.now(),
          "robot/odom",
          "robot/base_link",
          east,
          north,
          yaw,
          velocity.speed(),
          velocity.yawRate());
    }

    synchronized GpsFix fix() {
      return new GpsFix(
          GpsFix.Mode.FIX_3D,
          FRAME.toGeo(new LocalPosition(east, north, 0)),
          Instant.now(),
          velocity.speed(),
          (450 - Math.toDegrees(Math.IEEEremainder(yaw, 2 * Math.PI))) % 360,
          1,
          9,
          9);
    }

    synchronized void reset() {
      east = 0;
      north = 0;
      yaw = 0;
      velocity = Velocity.ZERO;
    }
  }

  /** Puts the body back to where it began, facing east. */
  static void reset() {
    BODY.reset();
  }

  /** Metres that it stands east of the datum. */
  static double east() {
    return BODY.move(0).x();
  }

  static GeoPosition at(double east, double north) {
    return FRAME.toGeo(new LocalPosition(east, north, 0));
  }

  /** Base of its sensors: each publishes so many times a second. */
  abstract static class Ticking extends SensorImpl {

    private final Scheduler time;
    private final double rate;
    private volatile boolean isOver;

    Ticking(ModuleContext context, String readingType, double rate) {
      super(
          context,
          "a sensor of a body without devices",
          "DFRA",
          "1",
          List.of(readingType),
          List.of());
      this.time = context.robotTime();
      this.rate = rate;
    }

    abstract void tick();

    private void tickAgain() {
      if (!isOver) {
        tick();
        Object unused = time.after(Math.round(1e9 / rate), this::tickAgain);
      }
    }

    @Override
    protected void onStart() {
      transitionTo(Readiness.READY);
      tickAgain();
    }

    @Override
    protected void onClose() {
      isOver = true;
    }

    @Override
    public double updateRate() {
      return rate;
    }
  }

  /** Counts how far it has come, and moves the body by that. */
  public static final class Counter extends Ticking implements OdometrySensor {

    public Counter(ModuleContext context) {
      super(context, "Odometry", 20);
    }

    @Override
    void tick() {
      publish(BODY.move(1 / updateRate()));
    }

    @Override
    public Odometry odometry() {
      return BODY.move(0);
    }
  }

  /** Knows where the body is. */
  public static final class Receiver extends Ticking implements GPSSensor {

    public Receiver(ModuleContext context) {
      super(context, "GpsFix", 5);
    }

    @Override
    void tick() {
      publish(fix());
    }

    @Override
    public GpsFix fix() {
      return BODY.fix();
    }

    @Override
    public LocationReading location() {
      return new LocationReading(DATUM, frame(), Instant.now());
    }

    @Override
    public TimeReading time() {
      return new TimeReading(Instant.now(), Instant.now());
    }
  }

  /** Sees nothing on the empty field, 181 times. */
  public static final class Laser extends Ticking implements RangeSensor {

    public Laser(ModuleContext context) {
      super(context, "RangeScan", 10);
    }

    @Override
    void tick() {
      publish(scan());
    }

    @Override
    public RangeScan scan() {
      float[] ranges = new float[181];
      Arrays.fill(ranges, Float.POSITIVE_INFINITY);
      return new RangeScan(
          Instant.now(), "robot/laser", -Math.PI / 2, Math.PI / 180, 0, 0, 80, ranges);
    }
  }

  /** Turns. */
  public static final class Wheels extends DriveImpl {

    public Wheels(ModuleContext context) {
      super(
          context,
          "wheels of a body without devices",
          "DFRA",
          "1",
          new DriveAttributes(1, 2, 0.78, 0.64),
          0.1,
          List.of());
    }

    @Override
    protected void onStart() {
      transitionTo(Readiness.READY);
    }

    @Override
    protected void onClose() {}

    @Override
    protected void setVelocity(Velocity wanted) {
      BODY.turn(wanted);
    }

    @Override
    protected void halt() {
      BODY.turn(Velocity.ZERO);
    }

    @Override
    protected void brake(boolean set) {}
  }
}
