package org.dfra.behaviors.perceptual.range;

import org.dfra.flow.perceptual.Clearance;
import org.dfra.flow.sensor.RangeScan;
import org.dfra.geometry.Transform;

/**
 * Computes the clearance around a robot's body from the end points of its beams.
 *
 * <pre>
 *              left: beyond 20° to the left
 *        \    .---------------------------
 *         \   |   corridor, 1.5 m wide       centre: in the corridor, or within 15° of ahead
 *   body [#####]--------------------------
 *         /   |
 *        /    '---------------------------
 *              right: beyond 20° to the right
 * </pre>
 *
 * @param halfLength of the body, metres
 * @param halfWidth of the body, metres
 * @param maxRange maximum range, metres; longer ranges are ignored
 */
record ClearanceCalculator(double halfLength, double halfWidth, double maxRange) {

  private static final double CORRIDOR = 0.75; // metres to each side
  private static final double AHEAD = Math.toRadians(15);
  private static final double SIDES = Math.toRadians(20);

  /** Maximum fraction of failed beams; with more the scan is unusable. */
  private static final double MOST_FAILED = 0.25;

  /** Collects the clearance to both sides from points outside the sensor's view. */
  final class SideClearance implements ObstacleMemory.PointConsumer {
    private double left = Double.POSITIVE_INFINITY;
    private double right = Double.POSITIVE_INFINITY;

    @Override
    public void accept(double x, double y) {
      if (y > 0) {
        left = Math.min(left, gap(x, y));
      } else {
        right = Math.min(right, gap(x, y));
      }
    }
  }

  /** Whether enough beams have measured for a usable result. */
  static boolean hasEnoughBeams(float[] ranges) {
    int failed = 0;
    for (float range : ranges) {
      failed += Float.isNaN(range) ? 1 : 0;
    }
    return ranges.length > 0 && failed <= MOST_FAILED * ranges.length;
  }

  /**
   * Computes the clearance.
   *
   * @param scan gives the beams' directions
   * @param ranges along them, metres; −∞ is at the sensor itself
   * @param mount of the sensor in the base's frame
   * @param sides points beside the robot, outside the sensor's view
   */
  Clearance clearance(
      RangeScan scan, float[] ranges, Transform mount, SideClearance sides, String frame) {
    double cos = Math.cos(mount.yaw());
    double sin = Math.sin(mount.yaw());
    double left = Math.min(maxRange, sides.left);
    double centre = maxRange;
    double right = Math.min(maxRange, sides.right);
    for (int i = 0; i < ranges.length; i++) {
      double range = Math.max(0, ranges[i]);
      if (!Double.isFinite(range)) {
        continue;
      }
      double along = range * Math.cos(scan.angle(i));
      double aside = range * Math.sin(scan.angle(i));
      double x = mount.x() + cos * along - sin * aside;
      double y = mount.y() + sin * along + cos * aside;
      double bearing = Math.atan2(y, x);
      if (x > 0 && (Math.abs(y) <= CORRIDOR || Math.abs(bearing) <= AHEAD)) {
        centre = Math.min(centre, Math.max(0, x - halfLength));
      }
      if (bearing > SIDES) {
        left = Math.min(left, gap(x, y));
      } else if (bearing < -SIDES) {
        right = Math.min(right, gap(x, y));
      }
    }
    return new Clearance(scan.measured(), frame, left, centre, right);
  }

  /**
   * The clearance reduced for moving objects. Without an object within the maximum range it is
   * unchanged.
   *
   * @param by distance of approach, metres
   */
  Clearance reducedBy(Clearance seen, double by) {
    return new Clearance(
        seen.measured(),
        seen.frame(),
        reducedBy(seen.left(), by),
        reducedBy(seen.centre(), by),
        reducedBy(seen.right(), by));
  }

  private double reducedBy(double clearance, double by) {
    return clearance >= maxRange ? clearance : Math.max(0, clearance - by);
  }

  /** From a point to the body, metres. */
  private double gap(double x, double y) {
    return Math.hypot(Math.max(0, Math.abs(x) - halfLength), Math.max(0, Math.abs(y) - halfWidth));
  }
}
