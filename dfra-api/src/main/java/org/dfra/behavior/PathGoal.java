package org.dfra.behavior;

import java.util.List;
import org.dfra.geometry.GeoPosition;
import org.jspecify.annotations.Nullable;

/**
 * To visit several places in order.
 *
 * @param from where the line to the first of them begins, frame WGS84; null for the robot's
 *     position
 * @param waypoints the places, frame WGS84; at least one
 * @param tolerance accepted distance from each, metres, above 0
 */
public record PathGoal(@Nullable GeoPosition from, List<GeoPosition> waypoints, double tolerance)
    implements Goal {

  public PathGoal {
    waypoints = List.copyOf(waypoints);
    if (waypoints.isEmpty()) {
      throw new IllegalArgumentException("a path needs one waypoint or more");
    }
    if (!(tolerance > 0 && Double.isFinite(tolerance))) {
      throw new IllegalArgumentException("tolerance " + tolerance + " m is not above 0");
    }
  }
}
