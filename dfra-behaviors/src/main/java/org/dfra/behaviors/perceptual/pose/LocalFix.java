package org.dfra.behaviors.perceptual.pose;

/**
 * A fix in the frame of a tracker.
 *
 * @param time of the fix itself, nanoseconds by the robot's clock
 * @param slot number of its receiver, 0 to {@link FixPreprocessor#MAX_RECEIVERS} less 1
 * @param isNewSource whether the slot belonged to another receiver before
 * @param east metres east of the datum, of the antenna
 * @param north metres north of it
 * @param forward metres from the robot's base forward to the antenna
 * @param left metres from the robot's base to the left to the antenna
 * @param sigma standard deviation of the white noise, east and north each, metres
 * @param speed over ground, metres per second
 * @param course direction of the antenna's travel in radians, 0 is east, counter-clockwise is +;
 *     NaN where it is too slow to determine
 */
record LocalFix(
    long time,
    int slot,
    boolean isNewSource,
    double east,
    double north,
    double forward,
    double left,
    double sigma,
    double speed,
    double course)
    implements FilterInput {

  /**
   * Direction of the antenna's travel in the robot's frame, radians from its x, to the left is +:
   * the antenna's velocity there is (v − ω·left, ω·forward).
   *
   * @param robotSpeed v, forward is +, metres per second
   * @param turnRate ω, to the left is +, radians per second
   */
  double antennaDirection(double robotSpeed, double turnRate) {
    return Math.atan2(turnRate * forward, robotSpeed - turnRate * left);
  }
}
