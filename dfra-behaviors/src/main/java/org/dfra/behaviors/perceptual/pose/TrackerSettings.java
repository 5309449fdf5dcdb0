package org.dfra.behaviors.perceptual.pose;

import java.time.Duration;

/**
 * What a tracker is told of its sensors and how patient it is. The defaults are the errors that the
 * simulated robots have.
 *
 * @param gps errors of the receivers
 * @param wheels errors of the odometry
 * @param gyro errors of the gyro
 * @param gate squared Mahalanobis distance of a position beyond which it is not believed, without
 *     unit; 13.8 is exceeded by one good position in a thousand (χ² of two)
 * @param courseGate the same of a course; 10.8 is exceeded by one in a thousand (χ² of one)
 * @param window how far back the fixes go that are compared with dead reckoning
 * @param horizon how late a fix may come, after the last odometry, to be used at its own time
 * @param lostAfter for how long all fixes must be disbelieved until the tracker doubts itself
 * @param startYawSigma standard deviation of the first yaw, radians, below which a Kalman filter
 *     begins
 */
public record TrackerSettings(
    GpsErrors gps,
    WheelErrors wheels,
    GyroErrors gyro,
    double gate,
    double courseGate,
    Duration window,
    Duration horizon,
    Duration lostAfter,
    double startYawSigma) {

  /** Those that fit the simulated robots. */
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
    Bounds.positive("gate", gate);
    Bounds.positive("course gate", courseGate);
    Bounds.positive("first yaw's standard deviation", startYawSigma);
    Bounds.span("window", window);
    Bounds.span("horizon", horizon);
    Bounds.span("time until lost", lostAfter);
  }

  /** The same with other receivers. */
  public TrackerSettings with(GpsErrors other) {
    return new TrackerSettings(
        other, wheels, gyro, gate, courseGate, window, horizon, lostAfter, startYawSigma);
  }

  /**
   * Errors of satellite receivers: a new one with each fix, and one that changes slowly, a
   * first-order Gauss-Markov process for each receiver.
   *
   * @param white standard deviation of the new one, east and north each, metres
   * @param bias standard deviation of the slow one, east and north each, metres; 0 is without
   * @param biasTime correlation time of the slow one, seconds
   * @param velocity standard deviation of the velocity, east and north each, metres per second
   * @param courseSpeed speed from which on the course is used, metres per second
   * @param leastLatency the least time from a fix's moment to its being heard, seconds; 0.16 is
   *     what 154 bytes take at 9600 baud
   * @param dilution dilution of precision up to which {@code white} holds; it grows in proportion
   *     beyond
   */
  public record GpsErrors(
      double white,
      double bias,
      double biasTime,
      double velocity,
      double courseSpeed,
      double leastLatency,
      double dilution) {

    /** No course is better than this, radians: bodies sway and slip to the side. */
    private static final double LEAST_COURSE = 0.03;

    /** 0.6 m new, 1.5 m slow over 200 s, 0.05 m/s. */
    public static final GpsErrors DEFAULT = new GpsErrors(0.6, 1.5, 200, 0.05, 0.4, 0.16, 3);

    public GpsErrors {
      Bounds.positive("white noise", white);
      Bounds.notNegative("bias", bias);
      Bounds.positive("bias time", biasTime);
      Bounds.positive("velocity noise", velocity);
      Bounds.positive("course speed", courseSpeed);
      Bounds.notNegative("least latency", leastLatency);
      Bounds.positive("dilution", dilution);
    }

    /** What a course is worth at a speed in metres per second: its standard deviation, radians. */
    double courseSigma(double speed) {
      return Math.max(LEAST_COURSE, velocity / speed);
    }

    /** The same with another slow error. */
    public GpsErrors withBias(double sigma) {
      return new GpsErrors(white, sigma, biasTime, velocity, courseSpeed, leastLatency, dilution);
    }
  }

  /**
   * Errors of wheels on the ground.
   *
   * @param scale standard deviation of the part by which they count too much or too little, without
   *     unit; it is estimated
   * @param turnScale the same of the turn, which a skid-steered body makes less of than its wheels;
   *     used and estimated where no gyro tells the turn
   * @param along standard deviation of the way after a metre, metres per root metre, from slip that
   *     changes
   * @param side the same to the side
   * @param turn standard deviation of the turn after a radian, radians per root radian; likewise
   * @param turnDrift what the counted turn drifts away, radians per root second; likewise
   * @param maxSpeed the fastest that the robot can be, metres per second
   * @param maxTurnRate the fastest that it can turn, radians per second
   */
  public record WheelErrors(
      double scale,
      double turnScale,
      double along,
      double side,
      double turn,
      double turnDrift,
      double maxSpeed,
      double maxTurnRate) {

    /** 3 % scale, 20 % of turns, 0.04 m after a metre, 0.2 rad after a radian. */
    public static final WheelErrors DEFAULT =
        new WheelErrors(0.03, 0.2, 0.04, 0.02, 0.2, 0.03, 3, 6);

    public WheelErrors {
      Bounds.notNegative("scale", scale);
      Bounds.positive("turn scale", turnScale);
      Bounds.positive("noise along", along);
      Bounds.positive("noise to the side", side);
      Bounds.positive("turn noise", turn);
      Bounds.positive("turn drift", turnDrift);
      Bounds.positive("fastest speed", maxSpeed);
      Bounds.positive("fastest turn", maxTurnRate);
    }
  }

  /**
   * Errors of a rate gyro.
   *
   * @param noise density of the white noise, rad/s per root hertz, which is radians per root second
   *     of turn; 0.0003 is 0.003 rad/s at 100 readings in a second
   * @param bias standard deviation of the rate it shows at rest at first, radians per second
   * @param drift what that has changed by after a second, rad/s per root second
   * @param scale standard deviation of the turn after a radian, radians per root radian
   */
  public record GyroErrors(double noise, double bias, double drift, double scale) {

    /** 0.003 rad/s white at 100 Hz, 0.005 rad/s bias that drifts by 0.0002. */
    public static final GyroErrors DEFAULT = new GyroErrors(3e-4, 0.005, 2e-4, 0.01);

    public GyroErrors {
      Bounds.positive("gyro noise", noise);
      Bounds.positive("gyro bias", bias);
      Bounds.positive("gyro drift", drift);
      Bounds.notNegative("gyro scale", scale);
    }
  }
}
