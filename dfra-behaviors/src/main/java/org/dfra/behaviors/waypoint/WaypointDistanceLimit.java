package org.dfra.behaviors.waypoint;

import java.util.List;
import java.util.Locale;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.geometry.GeoPosition;

/**
 * Maximum distance to a waypoint. A waypoint on another continent is treated as a typo.
 *
 * @param limit metres from the robot to a waypoint, above 0
 */
public record WaypointDistanceLimit(double limit) {

  /** Two kilometres. */
  public static final WaypointDistanceLimit DEFAULT = new WaypointDistanceLimit(2_000);

  public WaypointDistanceLimit {
    if (!(limit > 0)) {
      throw new IllegalArgumentException(
          "a maximum distance of " + limit + " m is not above 0; give a greater one");
    }
  }

  /**
   * Rejects a waypoint that is farther from the robot than the limit; heights are ignored.
   *
   * @param robot its position
   * @param waypoint the target
   * @throws GoalRefusedException with the distance and the remedy
   */
  public void requireWithin(GeoPosition robot, GeoPosition waypoint) {
    requireWithin("the robot at", robot, waypoint);
  }

  /**
   * Rejects a path with a leg longer than the limit: from the robot to the first waypoint, or from
   * one to the next.
   *
   * @param robot its position
   * @param waypoints the targets, in order
   * @throws GoalRefusedException with the waypoint and the remedy
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
              waypoint.latitudeAndLongitude(),
              length(distance),
              what,
              from.latitudeAndLongitude(),
              length(limit)));
    }
  }

  private static String length(double metres) {
    return metres < 10_000
        ? String.format(Locale.ROOT, "%.1f m", metres)
        : String.format(Locale.ROOT, "%.1f km", metres / 1_000);
  }
}
