package org.dfra.behaviors.perceptual.pose;

import org.dfra.behaviors.perceptual.pose.FilterInput.MotionIncrement;
import org.dfra.behaviors.perceptual.pose.FilterInput.MotionIncrement.Kind;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.Odometry;
import org.jspecify.annotations.Nullable;

/**
 * Builds motion increments from odometry and gyro. It uses only differences of odometry, so the
 * counts may start anywhere. A difference inconsistent with the reported speeds indicates a reset
 * of the controller's counts: the speeds are used instead.
 */
final class MotionIncrementBuilder {

  /** Time without motion after which wheels count as stationary, seconds. */
  private static final double REST = 0.5;

  private static final double STILL_WAY = 5e-4; // metres
  private static final double STILL_TURN = 5e-4; // radians
  private static final double STILL_SPEED = 0.01; // metres or radians per second

  /** Margin by which a difference may exceed 1.5 times that computed from the speeds. */
  private static final double JUMP_WAY = 0.3; // metres

  private static final double JUMP_TURN = 0.5; // radians

  /** Maximum gap for which a straight path is assumed, seconds. */
  private static final double LONG = 1;

  private static final double CURVED = 0.3; // fraction of the distance

  /** Motion noise without wheel data. */
  private static final double UNSEEN_SPEED = 1; // metres per second, standard deviation

  private static final double UNSEEN_RATE = 0.5; // radians per second, standard deviation
  private static final double MOST_LOST = 1000; // metres

  private final TrackerSettings.WheelErrors errors;
  private final TimestampMonitor continuity = new TimestampMonitor();
  private final GyroIntegrator gyro = new GyroIntegrator();
  private @Nullable Odometry last;
  private boolean hasBegun;
  private boolean isBlind;
  private long at;
  private double gyroAngle = Double.NaN;
  private int gyroStretch;
  private double still;

  MotionIncrementBuilder(TrackerSettings.WheelErrors errors) {
    this.errors = errors;
  }

  void take(AngularRate rate) {
    gyro.take(rate);
  }

  /** The increment since the last; null where this reading adds none. */
  @Nullable MotionIncrement take(Odometry odometry) {
    if (!EpochNanos.isPlausible(odometry.measured())) {
      return null;
    }
    long time = EpochNanos.of(odometry.measured());
    Odometry before = last;
    switch (continuity.classify(time)) {
      case OUT_OF_ORDER, SUSPECT -> {
        return null;
      }
      case FIRST, JUMP -> {
        last = odometry;
        return rejoin(time);
      }
      case NEXT -> last = odometry;
    }
    if (before == null || isBlind) {
      return rejoin(time);
    }
    return measured(before, odometry, time);
  }

  /** Continues at a time that is not continuous with the last odometry. */
  private @Nullable MotionIncrement rejoin(long time) {
    MotionIncrement step;
    if (hasBegun && at - time > TimestampMonitor.MAX_STEP_NANOS) {
      step =
          new MotionIncrement(
              time, time, 0, 0, Double.NaN, UNSEEN_SPEED, UNSEEN_RATE, Kind.CLOCK_JUMP);
      at = time;
      gyroAngle = gyro.angleAt(time);
      gyroStretch = gyro.segment();
    } else {
      step = unmeasured(time);
    }
    isBlind = time < at;
    return step;
  }

  /** The increment until a time without wheel data; null if there is none. */
  @Nullable MotionIncrement unmeasured(long time) {
    if (!hasBegun) {
      hasBegun = true;
      at = time;
      gyroAngle = gyro.angleAt(time);
      gyroStretch = gyro.segment();
      return null;
    }
    if (time <= at) {
      return null;
    }
    isBlind = true;
    still = 0;
    double dt = EpochNanos.seconds(at, time);
    double lost = Math.min(MOST_LOST, UNSEEN_SPEED * dt);
    return step(time, 0, 0, lost, Math.min(Math.PI, UNSEEN_RATE * dt), Kind.MOTION);
  }

  private MotionIncrement measured(Odometry before, Odometry now, long time) {
    double dt = EpochNanos.seconds(at, time);
    double middle = (before.yaw() + now.yaw()) / 2;
    double dx = now.x() - before.x();
    double dy = now.y() - before.y();
    double way = dx * Math.cos(middle) + dy * Math.sin(middle);
    double turn = Math.IEEEremainder(now.yaw() - before.yaw(), 2 * Math.PI);
    double fastest = Math.max(Math.abs(before.speed()), Math.abs(now.speed()));
    double quickest = Math.max(Math.abs(before.yawRate()), Math.abs(now.yawRate()));
    double distance = Math.hypot(dx, dy);
    double most = errors.maxSpeed() * dt;
    double mostTurn = Math.min(Math.PI, errors.maxYawRate() * dt);
    double lostWay = dt > LONG ? CURVED * Math.min(distance, most) : 0;
    double lostTurn = 0;
    if (Double.isNaN(way)
        || !(distance <= Math.min(most, 1.5 * fastest * dt) + JUMP_WAY)
        || !(Math.abs(turn) <= Math.min(mostTurn, 1.5 * quickest * dt) + JUMP_TURN)) {
      double speed = clamp((before.speed() + now.speed()) / 2, errors.maxSpeed());
      double rate = clamp((before.yawRate() + now.yawRate()) / 2, errors.maxYawRate());
      way = speed * dt;
      turn = rate * dt;
      lostWay = Math.min(Double.isNaN(distance) ? most : distance, most);
      lostTurn = mostTurn / 2;
    }
    boolean isStill =
        Math.abs(way) < STILL_WAY
            && Math.abs(turn) < STILL_TURN
            && fastest < STILL_SPEED
            && quickest < STILL_SPEED;
    still = isStill ? still + dt : 0;
    return step(
        time, way, turn, lostWay, lostTurn, still > REST ? Kind.STATIONARY_WHEELS : Kind.MOTION);
  }

  private MotionIncrement step(
      long time, double way, double turn, double lostWay, double lostTurn, Kind kind) {
    // From the last increment's end angle: corrects what it extrapolated for a late rate.
    double begin = gyroStretch == gyro.segment() ? gyroAngle : Double.NaN;
    begin = Double.isNaN(begin) ? gyro.angleAt(at) : begin;
    double end = gyro.angleAt(time);
    gyroAngle = end;
    gyroStretch = gyro.segment();
    long from = at;
    at = time;
    return new MotionIncrement(from, time, way, turn, end - begin, lostWay, lostTurn, kind);
  }

  /** The extrapolated increment from now on, for half a second at most. */
  MotionIncrement extrapolate(long time) {
    double dt = EpochNanos.seconds(at, time);
    double known = Math.min(dt, 0.5);
    double unknown = Math.min(MOST_LOST, dt - known);
    double end = gyro.angleAt(time);
    double turn = gyroStretch == gyro.segment() ? end - gyroAngle : Double.NaN;
    return new MotionIncrement(
        at,
        time,
        speed() * known,
        wheelYawRate() * known,
        turn,
        UNSEEN_SPEED * unknown,
        Math.min(Math.PI, UNSEEN_RATE * unknown),
        Kind.MOTION);
  }

  boolean hasBegun() {
    return hasBegun;
  }

  /** End of the increments, nanoseconds by the robot's clock. */
  long time() {
    return at;
  }

  /** Forward speed, metres per second, as the wheels last reported; 0 before. */
  double speed() {
    return last == null ? 0 : clamp(last.speed(), errors.maxSpeed());
  }

  /** Yaw rate from the wheels, radians per second, to the left is +; 0 before. */
  double wheelYawRate() {
    return last == null ? 0 : clamp(last.yawRate(), errors.maxYawRate());
  }

  /**
   * Yaw rate from the gyro, radians per second, to the left is +, bias included; NaN without data.
   */
  double gyroYawRate() {
    return Double.isNaN(gyro.angleAt(at)) ? Double.NaN : gyro.rate();
  }

  private static double clamp(double value, double most) {
    return Math.max(-most, Math.min(most, value));
  }
}
