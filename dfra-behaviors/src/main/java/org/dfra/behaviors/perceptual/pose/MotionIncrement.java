package org.dfra.behaviors.perceptual.pose;

/**
 * How a robot moved for a short while, as its sensors tell it.
 *
 * @param from when it began, nanoseconds by the robot's clock
 * @param time when it ended
 * @param distance metres that the wheels went, forward is +
 * @param wheelYaw radians that the wheels turned, to the left is +
 * @param gyroYaw radians that the gyro turned, its bias and all; NaN where it told nothing
 * @param distanceSigma standard deviation of a way not measured, east and north each, metres
 * @param yawSigma standard deviation of a turn that wheels did not measure, radians
 * @param areWheelsStationary whether the wheels have stood still for a while
 * @param isClockJump whether the clock was set: nothing before it is of use
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

  /** A gyro that shows this much beyond its error turns, though the wheels rest, rad/s. */
  private static final double TURNED = 0.01;

  double seconds() {
    return EpochNanos.seconds(from, time);
  }

  boolean hasGyro() {
    return !Double.isNaN(gyroYaw);
  }

  /**
   * Whether the robot stands. Wheels that rest are not enough: a gyro that turns says that it is
   * lifted or pushed.
   *
   * @param bias what the gyro is believed to show at rest, radians per second
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

  /** Its part until a time within it. */
  MotionIncrement before(long end) {
    return part(from, end);
  }

  /** Its part from a time within it. */
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
