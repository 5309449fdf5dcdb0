package org.dfra.behaviors.perceptual.pose;

import org.dfra.behaviors.perceptual.pose.FilterInput.MotionIncrement;

/**
 * The path by dead reckoning: concatenated motion increments, from 0, 0 and yaw 0. The gyro's bias
 * is its mean while the robot is stationary, over about the last minute of such time. A robot
 * rotated by hand is not stationary, though its wheels are.
 */
final class DeadReckoningTrack {

  /** More than a minute of increments at 20 Hz. */
  private static final int KEPT = 2048;

  /** Stationary time used, seconds. */
  private static final double REMEMBERED = 60;

  private final TrackerSettings.GyroErrors gyro;
  private final long[] times = new long[KEPT];
  private final double[] xs = new double[KEPT];
  private final double[] ys = new double[KEPT];
  private final double[] yaws = new double[KEPT];
  private long count;
  private double bias;
  private double rested;

  /** A pose on the track: metres and radians, not wrapped. */
  record Pose(double x, double y, double yaw) {}

  DeadReckoningTrack(TrackerSettings.GyroErrors gyro) {
    this.gyro = gyro;
  }

  /** Restarts at 0, 0 and yaw 0; keeps only the bias. */
  void begin(long time) {
    count = 0;
    put(time, 0, 0, 0);
  }

  void add(MotionIncrement step) {
    if (step.isClockJump() || count == 0) {
      begin(step.time());
      return;
    }
    double dt = step.seconds();
    boolean rests = step.isRobotStationary(bias, gyro.biasSigma(), gyro.noiseDensity());
    if (rests && step.hasGyro()) {
      double weight = Math.min(REMEMBERED, rested + dt);
      bias += (step.gyroYaw() / dt - bias) * dt / weight;
      rested = weight;
    }
    double turn = step.hasGyro() ? step.gyroYaw() - bias * dt : step.wheelYaw();
    double middle = yaw() + turn / 2;
    put(
        step.time(),
        x() + step.distance() * Math.cos(middle),
        y() + step.distance() * Math.sin(middle),
        yaw() + (rests ? 0 : turn));
  }

  private void put(long time, double x, double y, double yaw) {
    int at = (int) (count % KEPT);
    times[at] = time;
    xs[at] = x;
    ys[at] = y;
    yaws[at] = yaw;
    count++;
  }

  /** Gyro bias, radians per second; 0 before the robot was stationary. */
  double gyroBias() {
    return bias;
  }

  /** Stationary time so far, seconds, at most a minute. */
  double stationarySeconds() {
    return rested;
  }

  private int last() {
    return (int) ((count - 1) % KEPT);
  }

  private double x() {
    return xs[last()];
  }

  private double y() {
    return ys[last()];
  }

  private double yaw() {
    return yaws[last()];
  }

  /** Its end; the start if nothing was added. */
  Pose end() {
    return count == 0 ? new Pose(0, 0, 0) : new Pose(x(), y(), yaw());
  }

  /** Whether the pose of that time is known. */
  boolean covers(long time) {
    return count > 0 && time <= times[last()] && time >= times[(int) (oldest() % KEPT)];
  }

  private long oldest() {
    return Math.max(0, count - KEPT);
  }

  /** The pose at a time that it covers, interpolated linearly. */
  Pose at(long time) {
    long i = count - 1;
    while (i > oldest() && times[(int) (i % KEPT)] > time) {
      i--;
    }
    int a = (int) (i % KEPT);
    int b = (int) (Math.min(i + 1, count - 1) % KEPT);
    double part =
        times[b] == times[a]
            ? 0
            : EpochNanos.seconds(times[a], time) / EpochNanos.seconds(times[a], times[b]);
    return new Pose(
        xs[a] + part * (xs[b] - xs[a]),
        ys[a] + part * (ys[b] - ys[a]),
        yaws[a] + part * (yaws[b] - yaws[a]));
  }
}
