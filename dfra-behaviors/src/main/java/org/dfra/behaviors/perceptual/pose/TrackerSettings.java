package org.dfra.behaviors.perceptual.pose;

import java.time.Duration;

/**
 * Sensor errors and timeouts of a tracker. The defaults are the errors of the simulated robots.
 *
 * @param gps errors of the receivers
 * @param wheels errors of the odometry
 * @param gyro errors of the gyro
 * @param positionGate squared Mahalanobis distance of a position beyond which it is rejected,
 *     without unit; 13.8 is exceeded by one good position in a thousand (χ² of two)
 * @param courseGate the same of a course; 10.8 is exceeded by one in a thousand (χ² of one)
 * @param fixWindow length of the window of fixes that are aligned with dead reckoning
 * @param maxFixDelay maximum delay of a fix, after the last odometry, to be used at its own time
 * @param rejectionTimeout for how long all fixes must be rejected until the tracker inflates its
 *     covariance or restarts
 * @param maxInitialYawSigma standard deviation of the initial yaw, radians, below which a Kalman
 *     filter starts
 */
record TrackerSettings(
    GpsErrors gps,
    WheelErrors wheels,
    GyroErrors gyro,
    double positionGate,
    double courseGate,
    Duration fixWindow,
    Duration maxFixDelay,
    Duration rejectionTimeout,
    double maxInitialYawSigma) {

  /** Defaults for the simulated robots. */
  public static final TrackerSettings DEFAULT =
      new TrackerSettings(
          GpsErrors.DEFAULT,
          WheelErrors.DEFAULT,
          GyroErrors.DEFAULT,
          13.8,
          10.8,
          Duration.ofSeconds(20),
          Duration.ofSeconds(3),
          Duration.ofSeconds(8),
          0.2);

  public TrackerSettings {
    SettingsValidation.requirePositive("position_gate", positionGate);
    SettingsValidation.requirePositive("course_gate", courseGate);
    SettingsValidation.requirePositive("max_initial_yaw_sigma", maxInitialYawSigma);
    SettingsValidation.requireDuration("fix_window", fixWindow);
    SettingsValidation.requireDuration("max_fix_delay", maxFixDelay);
    SettingsValidation.requireDuration("rejection_timeout", rejectionTimeout);
  }

  /** The same with other receivers. */
  public TrackerSettings with(GpsErrors other) {
    return new TrackerSettings(
        other,
        wheels,
        gyro,
        positionGate,
        courseGate,
        fixWindow,
        maxFixDelay,
        rejectionTimeout,
        maxInitialYawSigma);
  }

  /**
   * Errors of satellite receivers: white noise of each fix, and a bias, a first-order Gauss-Markov
   * process for each receiver.
   *
   * @param whiteNoiseSigma standard deviation of the white noise, east and north each, metres
   * @param biasSigma standard deviation of the bias, east and north each, metres; 0 is without
   * @param biasCorrelationTime correlation time of the bias, seconds
   * @param velocitySigma standard deviation of the velocity, east and north each, metres per second
   * @param minCourseSpeed minimum speed to use the course, metres per second
   * @param minLatency minimum time from a fix's epoch to its reception, seconds; 0.16 is the
   *     transmission time of 154 bytes at 9600 baud
   * @param referenceDilution dilution of precision up to which {@code whiteNoiseSigma} applies;
   *     beyond, it grows in proportion
   */
  public record GpsErrors(
      double whiteNoiseSigma,
      double biasSigma,
      double biasCorrelationTime,
      double velocitySigma,
      double minCourseSpeed,
      double minLatency,
      double referenceDilution) {

    /** Minimum standard deviation of a course, radians: bodies sway and slip to the side. */
    private static final double LEAST_COURSE = 0.03;

    /** White noise 0.6 m, bias 1.5 m over 200 s, velocity 0.05 m/s. */
    public static final GpsErrors DEFAULT = new GpsErrors(0.6, 1.5, 200, 0.05, 0.4, 0.16, 3);

    public GpsErrors {
      SettingsValidation.requirePositive("gps_white_noise_sigma", whiteNoiseSigma);
      SettingsValidation.requireNonNegative("gps_bias_sigma", biasSigma);
      SettingsValidation.requirePositive("gps_bias_correlation_time", biasCorrelationTime);
      SettingsValidation.requirePositive("gps_velocity_sigma", velocitySigma);
      SettingsValidation.requirePositive("min_course_speed", minCourseSpeed);
      SettingsValidation.requireNonNegative("min_latency", minLatency);
      SettingsValidation.requirePositive("reference_dilution", referenceDilution);
    }

    /** Standard deviation of a course, radians, at a speed in metres per second. */
    double courseSigma(double speed) {
      return Math.max(LEAST_COURSE, velocitySigma / speed);
    }

    /** The same with another bias. */
    public GpsErrors withBias(double sigma) {
      return new GpsErrors(
          whiteNoiseSigma,
          sigma,
          biasCorrelationTime,
          velocitySigma,
          minCourseSpeed,
          minLatency,
          referenceDilution);
    }
  }

  /**
   * Errors of wheels on the ground.
   *
   * @param scaleSigma standard deviation of the scale error of distance, without unit; it is
   *     estimated
   * @param yawScaleSigma the same of the yaw, which is smaller for a skid-steered body than for its
   *     wheels; used and estimated without a gyro
   * @param longitudinalSlip standard deviation of the distance after a metre, metres per root
   *     metre, from varying slip
   * @param lateralSlip the same to the side
   * @param yawSlip standard deviation of the yaw after a radian, radians per root radian; likewise
   * @param yawRandomWalk random walk of the wheels' yaw, radians per root second; likewise
   * @param maxSpeed maximum speed of the robot, metres per second
   * @param maxYawRate its maximum yaw rate, radians per second
   */
  public record WheelErrors(
      double scaleSigma,
      double yawScaleSigma,
      double longitudinalSlip,
      double lateralSlip,
      double yawSlip,
      double yawRandomWalk,
      double maxSpeed,
      double maxYawRate) {

    /** 3 % of distance, 20 % of yaw, 0.04 m after a metre, 0.2 rad after a radian. */
    public static final WheelErrors DEFAULT =
        new WheelErrors(0.03, 0.2, 0.04, 0.02, 0.2, 0.03, 3, 6);

    public WheelErrors {
      SettingsValidation.requireNonNegative("wheel_scale_sigma", scaleSigma);
      SettingsValidation.requirePositive("wheel_yaw_scale_sigma", yawScaleSigma);
      SettingsValidation.requirePositive("wheel_slip", longitudinalSlip);
      SettingsValidation.requirePositive("wheel_lateral_slip", lateralSlip);
      SettingsValidation.requirePositive("wheel_yaw_slip", yawSlip);
      SettingsValidation.requirePositive("wheel_yaw_random_walk", yawRandomWalk);
      SettingsValidation.requirePositive("max_speed", maxSpeed);
      SettingsValidation.requirePositive("max_yaw_rate", maxYawRate);
    }
  }

  /**
   * Errors of a rate gyro.
   *
   * @param noiseDensity density of the white noise, rad/s per root hertz, which is radians of yaw
   *     per root second; 0.0003 is 0.003 rad/s at 100 readings in a second
   * @param biasSigma standard deviation of the initial bias, radians per second
   * @param biasRandomWalk random walk of the bias, rad/s per root second
   * @param scaleNoise standard deviation of the yaw after a radian, radians per root radian
   */
  public record GyroErrors(
      double noiseDensity, double biasSigma, double biasRandomWalk, double scaleNoise) {

    /** 0.003 rad/s white at 100 Hz, 0.005 rad/s bias that drifts by 0.0002. */
    public static final GyroErrors DEFAULT = new GyroErrors(3e-4, 0.005, 2e-4, 0.01);

    public GyroErrors {
      SettingsValidation.requirePositive("gyro_noise_density", noiseDensity);
      SettingsValidation.requirePositive("gyro_bias_sigma", biasSigma);
      SettingsValidation.requirePositive("gyro_bias_random_walk", biasRandomWalk);
      SettingsValidation.requireNonNegative("gyro_scale_noise", scaleNoise);
    }
  }

  /** Range checks of settings. */
  private static final class SettingsValidation {

    private static final Duration LONGEST = Duration.ofMinutes(2);

    private SettingsValidation() {}

    static void requirePositive(String what, double value) {
      if (!(value > 0 && value < Double.POSITIVE_INFINITY)) {
        throw new IllegalArgumentException(
            what + " " + value + " is not finite and above 0; give such a number");
      }
    }

    static void requireNonNegative(String what, double value) {
      if (!(value >= 0 && value < Double.POSITIVE_INFINITY)) {
        throw new IllegalArgumentException(
            what + " " + value + " is not finite and at least 0; give such a number");
      }
    }

    static void requireDuration(String what, Duration value) {
      if (value.isNegative() || value.isZero() || value.compareTo(LONGEST) > 0) {
        throw new IllegalArgumentException(
            what + " " + value + " is outside 0 to " + LONGEST + "; give one in that range");
      }
    }
  }
}
