package org.dfra.behavior;

import java.time.Duration;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.Leg;
import org.jspecify.annotations.Nullable;

/**
 * To follow a line to its end.
 *
 * @param from where the line begins, frame WGS84; null for the robot's position
 * @param to where it ends, frame WGS84
 * @param tolerance accepted distance from its end, metres, above 0
 * @param timeLimit the robot stops, and the goal fails, after this time from the goal's start, by
 *     the clock of the behaviour that pursues it; null for no limit. It stops a robot whose client
 *     cannot stop it because the client is suspended or disconnected
 */
public record LegGoal(
    @Nullable GeoPosition from, GeoPosition to, double tolerance, @Nullable Duration timeLimit)
    implements Goal {

  public LegGoal {
    if (!(tolerance > 0 && Double.isFinite(tolerance))) {
      throw new IllegalArgumentException("tolerance " + tolerance + " m is not above 0");
    }
    if (timeLimit != null && timeLimit.isNegative()) {
      throw new IllegalArgumentException("time limit " + timeLimit.toMillis() + " ms is below 0");
    }
  }

  /** Without a time limit. */
  public LegGoal(@Nullable GeoPosition from, GeoPosition to, double tolerance) {
    this(from, to, tolerance, null);
  }

  /** The same goal with a time limit. */
  public LegGoal withTimeLimit(Duration timeLimit) {
    return new LegGoal(from, to, tolerance, timeLimit);
  }

  /** Along a line. */
  public static LegGoal along(Leg leg, double tolerance) {
    return new LegGoal(leg.from(), leg.to(), tolerance);
  }
}
