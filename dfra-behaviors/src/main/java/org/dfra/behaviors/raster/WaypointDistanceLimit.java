package org.dfra.behaviors.raster;

import java.util.List;
import java.util.Locale;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.geometry.GeoPosition;

/**
 * How far a robot is sent at once. A waypoint on another continent is a slip of the pen, not a
 * goal.
 *
 * @param limit metres from the robot to a waypoint, above 0
 */
public record WaypointDistanceLimit(double limit) {

  /** Two kilometres. */
  public static final WaypointDistanceLimit DEFAULT = new WaypointDistanceLimit(2_000);

  public WaypointDistanceLimit {
    if (!(limit > 0)) {
      throw new IllegalArgumentException("a reach of " + limit + " m reaches nothing; give more");
    }
  }

  /**
   * Refuses a waypoint that is farther from the robot than the limit; heights do not count.
   *
   * @param robot where the robot is
   * @param waypoint where it is to go
   * @throws GoalRefusedException saying how far it is, and what to do
   */
  public void requireWithin(GeoPosition robot, GeoPosition waypoint) {
    requireWithin("the robot at", robot, waypoint);
  }

  /**
   * Refuses a path that goes farther than the limit at once: from the robot to the first waypoint,
   * or from one to the next.
   *
   * @param robot where the robot is
   * @param waypoints where it is to go, in order
   * @throws GoalRefusedException saying which is too far, and what to do
   */
  public void requireWithin(GeoPosition robot, List<GeoPosition> waypoints) {
    for (int i = 0; i < waypoints.size(); i++) {
      if (i == 0) {
        requireWithin(robot, waypoints.get(0));
      } else {
        requireWithin("the one before it,", waypoints.get(i - 1), waypoints.get(i));
      }
    }
  }

  private void requireWithin(String what, GeoPosition from, GeoPosition waypoint) {
    double distance = from.groundDistance(waypoint);
    if (!(distance <= limit)) {
      throw new GoalRefusedException(
          String.format(
              Locale.ROOT,
              "the waypoint %s is %s from %s %s, farther than %s; send a nearer one, and"
                  + " see that latitude and longitude are not swapped",
              RegionValidation.format(waypoint),
              length(distance),
              what,
              RegionValidation.format(from),
              length(limit)));
    }
  }

  private static String length(double metres) {
    return metres < 10_000
        ? String.format(Locale.ROOT, "%.1f m", metres)
        : String.format(Locale.ROOT, "%.1f km", metres / 1_000);
  }
}
