package org.dfra.app.demo.devices;

import org.dfra.flow.sensor.Odometry;
import org.jspecify.annotations.Nullable;

/**
 * Odometry that goes on where it was when its driver has died and begins to count anew. What the
 * wheels rolled meanwhile is counted by nobody. Safe for use by several threads.
 */
final class ContinuousOdometry {

  private long life = -1; // guarded by this: of the driver
  private @Nullable Odometry pose; // guarded by this
  private double[] base = {0, 0, 0}; // guarded by this: x, y, yaw of where the count began

  /**
   * Takes the next count and tells where the robot is by all of them.
   *
   * @param epoch which of its driver's lives it is from
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

  /** Where the robot is; null while nothing was counted. */
  synchronized @Nullable Odometry pose() {
    return pose;
  }

  /** The pose whose composition with this one is the origin. */
  private static double[] inverse(Odometry pose) {
    double cos = Math.cos(pose.yaw());
    double sin = Math.sin(pose.yaw());
    return new double[] {
      -cos * pose.x() - sin * pose.y(), sin * pose.x() - cos * pose.y(), -pose.yaw()
    };
  }

  /** First {@code in}, then {@code then} in its frame. */
  private static double[] compose(double[] in, double[] then) {
    double cos = Math.cos(in[2]);
    double sin = Math.sin(in[2]);
    return new double[] {
      in[0] + cos * then[0] - sin * then[1], in[1] + sin * then[0] + cos * then[1], in[2] + then[2]
    };
  }
}
