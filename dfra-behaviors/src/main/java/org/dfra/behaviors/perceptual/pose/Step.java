package org.dfra.behaviors.perceptual.pose;

/**
 * How a robot moved for a short while, as its sensors tell it.
 *
 * @param from when it began, nanoseconds by the robot's clock
 * @param time when it ended
 * @param way metres that the wheels went, forward is +
 * @param wheelTurn radians that the wheels turned, to the left is +
 * @param gyroTurn radians that the gyro turned, its bias and all; NaN where it told nothing
 * @param lostWay standard deviation of a way not measured, east and north each, metres
 * @param lostTurn standard deviation of a turn that wheels did not measure, radians
 * @param isResting whether the wheels have stood still for a while
 * @param isBreach whether the clock was set: nothing before it is of use
 */
record Step(
    long from,
    long time,
    double way,
    double wheelTurn,
    double gyroTurn,
    double lostWay,
    double lostTurn,
    boolean isResting,
    boolean isBreach)
    implements Event {

  /** A gyro that shows this much beyond its error turns, though the wheels rest, rad/s. */
  private static final double TURNED = 0.01;

  double seconds() {
    return Ticks.seconds(from, time);
  }

  boolean hasGyro() {
    return !Double.isNaN(gyroTurn);
  }

  /**
   * Whether the robot stands. Wheels that rest are not enough: a gyro that turns says that it is
   * lifted or pushed.
   *
   * @param bias what the gyro is believed to show at rest, radians per second
   * @param sigma standard deviation of that
   * @param noise density of the gyro's noise, radians per root second
   */
  boolean rests(double bias, double sigma, double noise) {
    double dt = seconds();
    if (!isResting || !(dt > 0)) {
      return false;
    }
    double spread = Math.sqrt(sigma * sigma + noise * noise / dt);
    return !hasGyro() || Math.abs(gyroTurn / dt - bias) < TURNED + 4 * spread;
  }

  /** Its part until a time within it. */
  Step before(long end) {
    return part(from, end);
  }

  /** Its part from a time within it. */
  Step after(long begin) {
    return part(begin, time);
  }

  private Step part(long begin, long end) {
    double share = Ticks.seconds(begin, end) / seconds();
    double root = Math.sqrt(share); // so that the variances of the parts add up
    return new Step(
        begin,
        end,
        way * share,
        wheelTurn * share,
        gyroTurn * share,
        lostWay * root,
        lostTurn * root,
        isResting,
        isBreach);
  }
}
