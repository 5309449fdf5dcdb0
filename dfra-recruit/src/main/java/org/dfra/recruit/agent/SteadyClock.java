package org.dfra.recruit.agent;

import java.time.Instant;
import java.time.InstantSource;
import org.dfra.time.Scheduler;

/**
 * A clock that a monotonic timer advances from its start. Setting the computer's clock changes no
 * timeout: two robots that measure the same timeout must not diverge. {@link AgentMemory} sets its
 * start, so that it continues in the next process.
 */
final class SteadyClock implements InstantSource {

  private final Instant began;
  private final long beganNanos;
  private final Scheduler timer;

  /**
   * @param began its current time
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
