package org.dfra.behavior;

import java.time.Duration;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.Leg;
import org.jspecify.annotations.Nullable;

/**
 * To be at the end of a line, by way of the line.
 *
 * @param from where the line begins, frame WGS84; null for where the robot is
 * @param to where it ends, frame WGS84
 * @param tolerance how near its end is near enough, metres, above 0
 * @param timeLimit the robot stops, and the goal has failed, when this has passed since it was
 *     begun, by the clock of the behaviour that pursues it; null for no limit. It ends a drive
 *     whose client cannot end it: a client that is suspended, or cut off
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
