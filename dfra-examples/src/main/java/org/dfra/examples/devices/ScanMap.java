package org.dfra.examples.devices;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.util.ArrayList;
import java.util.List;
import org.dfra.flow.sensor.Odometry;
import org.dfra.flow.sensor.RangeScan;
import org.dfra.geometry.Transform;
import org.jspecify.annotations.Nullable;

/**
 * End points of the laser beams, by the odometry at that time, in the frame in which the robot
 * started. Thread-safe.
 */
final class ScanMap {

  /** One beam in this many, of one scan in this many: enough to show walls. */
  private static final int BEAMS = 3;

  private static final int SCANS = 3;

  @GuardedBy("this")
  private final List<double[]> points = new ArrayList<>();

  @GuardedBy("this")
  private @Nullable Odometry pose;

  @GuardedBy("this")
  private Transform mount = Transform.IDENTITY;

  @GuardedBy("this")
  private int scans;

  /** The mounting pose of the laser on the robot. */
  synchronized void mounted(Transform on) {
    mount = on;
  }

  /** Sets the robot's current pose. */
  synchronized void at(Odometry now) {
    pose = now;
  }

  /** Adds a scan taken from the current pose. */
  synchronized void add(RangeScan scan) {
    @Nullable Odometry at = pose;
    if (at == null || scans++ % SCANS != 0) {
      return;
    }
    double cos = Math.cos(at.yaw());
    double sin = Math.sin(at.yaw());
    for (int i = 0; i < scan.beams(); i += BEAMS) {
      if (scan.isMeasured(i)) {
        double angle = mount.yaw() + scan.angle(i);
        double x = mount.x() + scan.range(i) * Math.cos(angle);
        double y = mount.y() + scan.range(i) * Math.sin(angle);
        points.add(new double[] {at.x() + cos * x - sin * y, at.y() + sin * x + cos * y});
      }
    }
  }

  /** All points as {@code {x, y}}, metres. */
  synchronized double[][] points() {
    return new double[][] {
      points.stream().mapToDouble(point -> point[0]).toArray(),
      points.stream().mapToDouble(point -> point[1]).toArray()
    };
  }
}
