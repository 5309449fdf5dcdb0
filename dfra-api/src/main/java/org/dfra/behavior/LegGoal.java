package org.dfra.behavior;

import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.Leg;
import org.jspecify.annotations.Nullable;

/**
 * To be at the end of a line, by way of the line.
 *
 * @param from where the line begins, frame WGS84; null for where the robot is
 * @param to where it ends, frame WGS84
 * @param tolerance how near its end is near enough, metres, above 0
 */
public record LegGoal(@Nullable GeoPosition from, GeoPosition to, double tolerance)
    implements Goal {

  public LegGoal {
    if (!(tolerance > 0 && Double.isFinite(tolerance))) {
      throw new IllegalArgumentException("tolerance " + tolerance + " m is not above 0");
    }
  }

  /** Along a line. */
  public static LegGoal along(Leg leg, double tolerance) {
    return new LegGoal(leg.from(), leg.to(), tolerance);
  }
}
