package org.dfra.recruit.agent;

import java.time.Instant;
import java.time.InstantSource;
import org.dfra.time.Scheduler;

/**
 * A clock that a timer moves on from where it began. Somebody who sets the computer's clock
 * meanwhile moves no time-out: two robots that count the same span must not come to differ by that.
 * {@link AgentMemory} says where it begins, so that it goes on in the next process.
 */
final class SteadyClock implements InstantSource {

  private final Instant began;
  private final long beganNanos;
  private final Scheduler timer;

  /**
   * @param began what it says now
   */
  SteadyClock(Instant began, Scheduler timer) {
    this.began = began;
    this.beganNanos = timer.nanos();
    this.timer = timer;
  }

  @Override
  public Instant instant() {
    return began.plusNanos(timer.nanos() - beganNanos);
  }
}
