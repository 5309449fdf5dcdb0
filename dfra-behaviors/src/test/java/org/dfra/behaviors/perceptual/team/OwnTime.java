package org.dfra.behaviors.perceptual.team;

import java.time.Instant;
import java.time.InstantSource;
import org.dfra.behaviors.SteppedTime;
import org.dfra.time.Scheduler;

/** A robot's clock that is wrong: it is ahead of a test's true time, and drifts. */
final class OwnTime implements InstantSource, Scheduler {

  private final SteppedTime truth;
  private final double ahead;
  private final double drift;

  /**
   * @param ahead seconds at the beginning, + is ahead
   * @param drift seconds that it gains in a second
   */
  OwnTime(SteppedTime truth, double ahead, double drift) {
    this.truth = truth;
    this.ahead = ahead;
    this.drift = drift;
  }

  /** What it is ahead by now, seconds. */
  double ahead() {
    return ahead + drift * truth.nanos() / 1e9;
  }

  @Override
  public Instant instant() {
    return truth.instant().plusNanos(Math.round(ahead() * 1e9));
  }

  @Override
  public long nanos() {
    return truth.nanos();
  }

  @Override
  public ScheduledTask after(long nanos, Runnable task) {
    return truth.after(nanos, task);
  }

  @Override
  public boolean isLockStep() {
    return true;
  }
}
