package org.dfra.behavior;

import java.time.Instant;
import java.util.UUID;
import org.dfra.event.Reading;
import org.jspecify.annotations.Nullable;

/**
 * How far a behaviour is; told whenever it changes.
 *
 * @param measured when it was so, by the robot's clock, UTC
 * @param goal names the pursuit; null where there has not been any
 * @param phase where it is in the picture at {@link Phase}
 * @param activity what it does or why it does not, for people, as a clause
 * @param completion share of the goal that is dealt with, 0 to 1; never falls during a pursuit
 * @param skippedParts how many parts of that, such as waypoints, were left out, since they could
 *     not be reached
 * @param heldSince when a person, a parking brake or an emergency stop stopped it, by the robot's
 *     clock, UTC; no program resumes it. Null where none of them has, and from the next goal on
 * @param completedParts how many of the goal's parts, such as waypoints, are dealt with, those that
 *     were left out among them
 * @param totalParts how many parts the goal has; 0 where they are not counted, as by servers that
 *     are older than this number
 */
public record BehaviorStatus(
    Instant measured,
    @Nullable UUID goal,
    Phase phase,
    String activity,
    double completion,
    int skippedParts,
    @Nullable Instant heldSince,
    int completedParts,
    int totalParts)
    implements Reading {

  /**
   * What a behaviour is at.
   *
   * <pre>
   *   IDLE --pursue--&gt; RUNNING --reached--&gt; SUCCEEDED
   *                     |  ^ '--cannot be reached--&gt; FAILED
   *               pause |  | resume
   *                     v  |
   *                    PAUSED --cancel--&gt; CANCELLED  (from RUNNING likewise)
   * </pre>
   *
   * <p>From each phase on the right the next goal leads to RUNNING again. A goal that was RUNNING
   * when the behaviour's process died is IDLE in the next process: nobody pursues it, and nobody
   * has stopped it. Whoever pauses or cancels it then finds it CANCELLED.
   */
  public enum Phase {
    IDLE,
    RUNNING,
    PAUSED,
    SUCCEEDED,
    FAILED,
    CANCELLED;

    /** Whether a goal is being pursued, even if not now. */
    public boolean isUnderWay() {
      return this == RUNNING || this == PAUSED;
    }
  }

  /** Of a goal that nobody has stopped, and whose parts are not counted. */
  public BehaviorStatus(
      Instant measured, @Nullable UUID goal, Phase phase, String doing, double done, int missed) {
    this(measured, goal, phase, doing, done, missed, null, 0, 0);
  }

  public BehaviorStatus {
    if (!(completion >= 0 && completion <= 1)) {
      throw new IllegalArgumentException("done " + completion + " is outside 0 to 1");
    }
    if (skippedParts < 0) {
      throw new IllegalArgumentException("missed " + skippedParts + " is below 0");
    }
    if (completedParts < 0 || completedParts > totalParts) {
      throw new IllegalArgumentException(
          "parts done "
              + completedParts
              + " is outside 0 to "
              + totalParts
              + ", the parts of the goal");
    }
  }
}
