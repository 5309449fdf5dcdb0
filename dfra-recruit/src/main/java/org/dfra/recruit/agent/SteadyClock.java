package org.dfra.recruit.agent;

import java.time.Instant;
import java.time.InstantSource;
import org.dfra.time.Scheduler;

/**
 * A clock as it was when this was made, moved on by a timer. Somebody who sets the computer's clock
 * meanwhile moves no time-out: two robots that count the same span must not come to differ by that.
 */
final class SteadyClock implements InstantSource {

  private final Instant began;
  private final long beganNanos;
  private final Scheduler timer;

  SteadyClock(InstantSource clock, Scheduler timer) {
    this.began = clock.instant();
    this.beganNanos = timer.nanos();
    this.timer = timer;
  }

  @Override
  public Instant instant() {
    return began.plusNanos(timer.nanos() - beganNanos);
  }
}
