package org.dfra.behaviors.perceptual.pose;

/**
 * A robot's motion in a short interval, measured by its sensors.
 *
 * @param from start time, nanoseconds by the robot's clock
 * @param time end time
 * @param distance of the wheels, metres, forward is +
 * @param wheelYaw yaw from the wheels, radians, to the left is +
 * @param gyroYaw yaw from the gyro, radians, bias included; NaN without data
 * @param distanceSigma standard deviation of an unmeasured path, east and north each, metres
 * @param yawSigma standard deviation of a yaw that the wheels did not measure, radians
 * @param areWheelsStationary whether the wheels have been stationary for a while
 * @param isClockJump whether the clock was set: earlier data is useless
 */
record MotionIncrement(
    long from,
    long time,
    double distance,
    double wheelYaw,
    double gyroYaw,
    double distanceSigma,
    double yawSigma,
    boolean areWheelsStationary,
    boolean isClockJump)
    implements FilterInput {

  /**
   * Gyro rate beyond its error that indicates rotation, though the wheels are stationary, rad/s.
   */
  private static final double TURNED = 0.01;

  double seconds() {
    return EpochNanos.seconds(from, time);
  }

  boolean hasGyro() {
    return !Double.isNaN(gyroYaw);
  }

  /**
   * Whether the robot is stationary. Stationary wheels are not sufficient: a gyro rate shows that
   * it is lifted or pushed.
   *
   * @param bias estimated gyro bias, radians per second
   * @param sigma standard deviation of that
   * @param noise density of the gyro's noise, radians per root second
   */
  boolean isRobotStationary(double bias, double sigma, double noise) {
    double dt = seconds();
    if (!areWheelsStationary || !(dt > 0)) {
      return false;
    }
    double spread = Math.sqrt(sigma * sigma + noise * noise / dt);
    return !hasGyro() || Math.abs(gyroYaw / dt - bias) < TURNED + 4 * spread;
  }

  /** The part until a time within it. */
  MotionIncrement before(long end) {
    return part(from, end);
  }

  /** The part from a time within it. */
  MotionIncrement after(long begin) {
    return part(begin, time);
  }

  private MotionIncrement part(long begin, long end) {
    double share = EpochNanos.seconds(begin, end) / seconds();
    double root = Math.sqrt(share); // so that the variances of the parts add up
    return new MotionIncrement(
        begin,
        end,
        distance * share,
        wheelYaw * share,
        gyroYaw * share,
        distanceSigma * root,
        yawSigma * root,
        areWheelsStationary,
        isClockJump);
  }
}
