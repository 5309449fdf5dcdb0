package org.dfra.behaviors.perceptual.pose;

/** An input that predicts or corrects a belief, in the order of time. */
sealed interface FilterInput permits FilterInput.MotionIncrement, FilterInput.LocalFix {

  /** Its end, nanoseconds by the robot's clock. */
  long time();

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
     * @param yawRate ω, to the left is +, radians per second
     */
    double antennaDirection(double robotSpeed, double yawRate) {
      return Math.atan2(yawRate * forward, robotSpeed - yawRate * left);
    }
  }

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
   * @param kind what is special about the interval
   */
  record MotionIncrement(
      long from,
      long time,
      double distance,
      double wheelYaw,
      double gyroYaw,
      double distanceSigma,
      double yawSigma,
      Kind kind)
      implements FilterInput {

    /** Kinds of increments. */
    enum Kind {
      /** The wheels may move. */
      MOTION,
      /** The wheels have been stationary for a while. */
      STATIONARY_WHEELS,
      /** The clock was set: earlier data is useless. */
      CLOCK_JUMP
    }

    boolean areWheelsStationary() {
      return kind == Kind.STATIONARY_WHEELS;
    }

    boolean isClockJump() {
      return kind == Kind.CLOCK_JUMP;
    }

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
     * @param gyroBias estimated gyro bias, radians per second
     * @param sigma standard deviation of that
     * @param noise density of the gyro's noise, radians per root second
     */
    boolean isRobotStationary(double gyroBias, double sigma, double noise) {
      double dt = seconds();
      if (!areWheelsStationary() || !(dt > 0)) {
        return false;
      }
      double spread = Math.sqrt(sigma * sigma + noise * noise / dt);
      return !hasGyro() || Math.abs(gyroYaw / dt - gyroBias) < TURNED + 4 * spread;
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
          kind);
    }
  }
}
