package org.dfra.sim.world;

import java.time.Duration;
import java.time.Instant;

/**
 * Maps the steps of a world to time.
 *
 * @param start time of the first one, 0
 */
record Timeline(Instant start) {

  private static final long STEP_NANOS = World.STEP.toNanos();
  private static final long PER_SECOND = 1_000_000_000 / STEP_NANOS;

  /** The step that a time belongs to: the last one that is not after it; 0 before the start. */
  long step(Instant time) {
    if (time.isBefore(start)) {
      return 0;
    }
    Duration since = Duration.between(start, time);
    return since.getSeconds() * PER_SECOND + since.getNano() / STEP_NANOS;
  }

  /** The time of a step. */
  Instant instant(long step) {
    return start.plusNanos(step * STEP_NANOS);
  }
}
