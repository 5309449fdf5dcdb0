package org.dfra.behavior;

import java.time.Instant;
import java.util.UUID;
import org.dfra.event.Reading;
import org.jspecify.annotations.Nullable;

/**
 * The progress of a behaviour, published whenever it changes.
 *
 * @param measured when this was the status, by the robot's clock, UTC
 * @param goal the goal's identity; null if there has not been a goal
 * @param phase its phase, see the diagram at {@link Phase}
 * @param activity what it does, or why it does nothing, as a clause for operators
 * @param completion fraction of the goal that is finished, 0 to 1; never decreases during a goal
 * @param skippedParts how many of those parts, such as waypoints, were skipped because they could
 *     not be reached
 * @param heldSince when an operator, a parking brake or an emergency stop stopped it, by the
 *     robot's clock, UTC; no program resumes it. Null if none of them has, and from the next goal
 *     on
 * @param completedParts how many of the goal's parts, such as waypoints, are finished, including
 *     skipped ones
 * @param totalParts how many parts the goal has; 0 if they are not counted, as by servers older
 *     than this component
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
   * The phase of a behaviour.
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
   * when the behaviour's process died is IDLE in the next process: it is neither pursued nor
   * stopped. Pausing or cancelling it then makes it CANCELLED.
   */
  public enum Phase {
    IDLE,
    RUNNING,
    PAUSED,
    SUCCEEDED,
    FAILED,
    CANCELLED;

    /** Whether a goal is in progress, running or paused. */
    public boolean isUnderWay() {
      return this == RUNNING || this == PAUSED;
    }
  }

  /** The status of a goal that is not held and whose parts are not counted. */
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
