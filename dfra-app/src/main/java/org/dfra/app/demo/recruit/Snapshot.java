package org.dfra.app.demo.recruit;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.behavior.BehaviorStatus;
import org.jspecify.annotations.Nullable;

/**
 * The team at one moment, as far as is known. A null is what nobody has told.
 *
 * @param began when the demonstration did, robots' time
 * @param time of it, robots' time
 * @param robots each once
 * @param call that is under way; null where nobody calls
 */
record Snapshot(Instant began, Instant time, List<Robot> robots, @Nullable CallState call) {

  Snapshot {
    robots = List.copyOf(robots);
  }

  /** Seconds of the robots' time since the demonstration began. */
  double seconds() {
    return Duration.between(began, time).toMillis() / 1000.0;
  }

  /** What can become of a robot that its own modules do not tell. */
  enum Availability {
    /** Not seen yet. */
    ABSENT,
    /** At work. */
    PRESENT,
    /** Its agent hears and says nothing. */
    UNREACHABLE,
    /** Nothing of it is left but a stopped vehicle. */
    DEAD
  }

  /**
   * One robot.
   *
   * @param isFlying whether it is in the air
   * @param agent what its agent has told last; null where that has not changed yet, or is unknown
   * @param search what its search has told last; null where it has none
   * @param distance to where it is needed, metres, as the crow flies; null where it is not under
   *     way
   * @param lease seconds of the robots' time for which it yet stays; null where it has granted none
   * @param charge left, 0 to 1; null where it is not known
   */
  record Robot(
      String name,
      Availability fate,
      boolean isFlying,
      @Nullable RecruitmentStatus agent,
      @Nullable BehaviorStatus search,
      @Nullable Double distance,
      @Nullable Double lease,
      @Nullable Double charge) {}
}
