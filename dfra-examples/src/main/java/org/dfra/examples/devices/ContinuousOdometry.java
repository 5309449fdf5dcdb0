package org.dfra.examples.devices;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import org.dfra.flow.sensor.Odometry;
import org.jspecify.annotations.Nullable;

/**
 * Odometry that stays continuous when its driver process dies and counts from zero again. The
 * motion of the wheels in between is lost. Thread-safe.
 */
final class ContinuousOdometry {

  // of the driver
  @GuardedBy("this")
  private long life = -1;

  @GuardedBy("this")
  private @Nullable Odometry pose;

  // x, y, yaw where the count started
  @GuardedBy("this")
  private double[] base = {0, 0, 0};

  /**
   * Adds the next count and returns the pose by all counts.
   *
   * @param epoch the driver's epoch that it is from
   */
  synchronized Odometry next(Odometry counted, long epoch) {
    if (epoch != life) {
      life = epoch;
      double[] until = pose == null ? base : new double[] {pose.x(), pose.y(), pose.yaw()};
      base = compose(until, inverse(counted));
    }
    double[] at = compose(base, new double[] {counted.x(), counted.y(), counted.yaw()});
    pose =
        new Odometry(
            counted.measured(),
            counted.frame(),
            counted.childFrame(),
            at[0],
            at[1],
            at[2],
            counted.speed(),
            counted.yawRate());
    return pose;
  }

  /** The robot's pose; null before the first count. */
  synchronized @Nullable Odometry pose() {
    return pose;
  }

  /** The inverse pose: composed with this pose it gives the origin. */
  private static double[] inverse(Odometry pose) {
    double cos = Math.cos(pose.yaw());
    double sin = Math.sin(pose.yaw());
    return new double[] {
      -cos * pose.x() - sin * pose.y(), sin * pose.x() - cos * pose.y(), -pose.yaw()
    };
  }

  /** The pose {@code then}, given in the frame of pose {@code in}. */
  private static double[] compose(double[] in, double[] then) {
    double cos = Math.cos(in[2]);
    double sin = Math.sin(in[2]);
    return new double[] {
      in[0] + cos * then[0] - sin * then[1], in[1] + sin * then[0] + cos * then[1], in[2] + then[2]
    };
  }
}
