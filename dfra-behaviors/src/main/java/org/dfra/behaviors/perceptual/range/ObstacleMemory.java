package org.dfra.behaviors.perceptual.range;

import java.time.Duration;
import java.util.HashMap;
import java.util.Iterator;
import java.util.Map;
import org.dfra.flow.sensor.Odometry;
import org.dfra.flow.sensor.RangeScan;
import org.dfra.geometry.Transform;

/**
 * Stores obstacle points that the robot has passed and its sensor does not see any more: in a
 * rotation its rear could hit them. Points are stored in the odometry's frame for a limited time,
 * measured by monotonic time: setting the clock neither drops nor keeps them. Confined to one
 * thread.
 */
final class ObstacleMemory {

  private static final double CELL = 0.05; // metres; of the points in one cell, the last is stored
  private static final double NEAR = 2; // metres from the robot's centre, of stored points
  private static final int MOST = 2000;

  private record Cell(long x, long y) {}

  private record Point(double x, double y, long seenNanos) {}

  /** Receives points in the base's frame, metres. */
  @FunctionalInterface
  interface PointConsumer {
    void accept(double x, double y);
  }

  private final long memoryNanos;
  private final Map<Cell, Point> points = new HashMap<>(); // in the odometry's frame

  /**
   * @param memory how long an unseen point is stored
   */
  ObstacleMemory(Duration memory) {
    this.memoryNanos = memory.toNanos();
  }

  /**
   * Adds a scan: points in its view are replaced by its measurements, the rest stays.
   *
   * @param ranges along the beams, metres
   * @param mount of the sensor in the base
   * @param at pose of the base
   * @param nanos the robot's monotonic time when the scan was received
   */
  void take(RangeScan scan, float[] ranges, Transform mount, Odometry at, long nanos) {
    forget(scan, mount, at, nanos);
    double cos = Math.cos(mount.yaw());
    double sin = Math.sin(mount.yaw());
    for (int i = 0; i < ranges.length && points.size() < MOST; i++) {
      double range = ranges[i];
      if (!Double.isFinite(range) || range < 0) {
        continue;
      }
      double along = range * Math.cos(scan.angle(i));
      double aside = range * Math.sin(scan.angle(i));
      double x = mount.x() + cos * along - sin * aside;
      double y = mount.y() + sin * along + cos * aside;
      if (Math.hypot(x, y) <= NEAR) {
        double east = at.x() + Math.cos(at.yaw()) * x - Math.sin(at.yaw()) * y;
        double north = at.y() + Math.sin(at.yaw()) * x + Math.cos(at.yaw()) * y;
        points.put(
            new Cell(Math.round(east / CELL), Math.round(north / CELL)),
            new Point(east, north, nanos));
      }
    }
  }

  private void forget(RangeScan scan, Transform mount, Odometry at, long nanos) {
    double first = scan.firstAngle();
    double last = scan.angle(scan.beams() - 1);
    double low = Math.min(first, last);
    double high = Math.max(first, last);
    for (Iterator<Point> all = points.values().iterator(); all.hasNext(); ) {
      Point point = all.next();
      double x = forward(point, at);
      double y = left(point, at);
      double bearing =
          Math.IEEEremainder(Math.atan2(y - mount.y(), x - mount.x()) - mount.yaw(), 2 * Math.PI);
      boolean isSeen = bearing >= low && bearing <= high;
      if (isSeen || Math.hypot(x, y) > NEAR || nanos - point.seenNanos() > memoryNanos) {
        all.remove();
      }
    }
  }

  /** Clears all: the position reference was lost. */
  void clear() {
    points.clear();
  }

  /** The stored points, relative to the current pose of the base. */
  void forEach(Odometry at, PointConsumer taker) {
    for (Point each : points.values()) {
      taker.accept(forward(each, at), left(each, at));
    }
  }

  private static double forward(Point point, Odometry at) {
    return Math.cos(at.yaw()) * (point.x() - at.x()) + Math.sin(at.yaw()) * (point.y() - at.y());
  }

  private static double left(Point point, Odometry at) {
    return Math.cos(at.yaw()) * (point.y() - at.y()) - Math.sin(at.yaw()) * (point.x() - at.x());
  }
}
