package org.dfra.examples.recruit;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.behavior.BehaviorStatus;
import org.jspecify.annotations.Nullable;

/**
 * The team at one moment, as far as known. A null is a value that was not reported.
 *
 * @param began start of the demonstration, robots' time
 * @param time of the snapshot, robots' time
 * @param robots each once
 * @param call the running call; null if there is none
 */
record Snapshot(Instant began, Instant time, List<Robot> robots, @Nullable CallState call) {

  Snapshot {
    robots = List.copyOf(robots);
  }

  /** Seconds of the robots' time since the demonstration began. */
  double seconds() {
    return Duration.between(began, time).toMillis() / 1000.0;
  }

  /** Availability of a robot, which its own modules do not report. */
  enum Availability {
    /** Not discovered yet. */
    ABSENT,
    /** Working. */
    PRESENT,
    /** Its agent neither receives nor sends messages. */
    UNREACHABLE,
    /** Only its stopped vehicle is left. */
    DEAD
  }

  /**
   * One robot.
   *
   * @param isFlying whether it is in the air
   * @param agent the last status of its agent; null if there is none yet, or it is unknown
   * @param search the last status of its search; null if it has none
   * @param distance to the place where help is needed, metres, in a straight line; null unless it
   *     is travelling
   * @param lease remaining lease time, seconds of the robots' time; null if it has granted none
   * @param charge left, 0 to 1; null if not known
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
