package org.dfra.behaviors;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import org.dfra.time.Scheduler;

/** The stepped time of one process: once that is dead, nothing that it had planned happens. */
final class MortalTime implements InstantSource, Scheduler {

  private final SteppedTime time;
  private boolean isDead;
  private Duration ahead = Duration.ZERO;

  MortalTime(SteppedTime time) {
    this.time = time;
  }

  /** As {@code kill -9}. */
  void die() {
    isDead = true;
  }

  /** Has its computer's clock be so far ahead of the others; no span changes by that. */
  void setAhead(Duration span) {
    ahead = span;
  }

  @Override
  public Instant instant() {
    return time.instant().plus(ahead);
  }

  @Override
  public long nanos() {
    return time.nanos();
  }

  @Override
  public ScheduledTask after(long nanos, Runnable task) {
    return time.after(
        nanos,
        () -> {
          if (!isDead) {
            task.run();
          }
        });
  }

  @Override
  public boolean isLockStep() {
    return true;
  }
}
