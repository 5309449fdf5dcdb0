package org.dfra.recruit.transport;

import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.random.RandomGenerator;
import org.dfra.time.Scheduler;

/** Wraps a scheduler; its tasks run slightly late, as on a busy computer. */
public final class LateScheduler implements Scheduler {

  private final Scheduler exact;
  private final DelayModel late;
  private final RandomGenerator lot;

  /**
   * @param delay of each task
   * @param random source of random numbers
   */
  public LateScheduler(Scheduler exact, DelayModel delay, RandomGenerator random) {
    this.exact = exact;
    this.late = delay;
    this.lot = random;
  }

  @Override
  public long nanos() {
    return exact.nanos();
  }

  @Override
  public ScheduledTask after(long nanos, Runnable task) {
    return exact.after(Math.max(0, nanos) + Math.round(late.next(lot) * 1e9), task);
  }

  @Override
  public Condition newCondition(ReentrantLock lock) {
    return exact.newCondition(lock);
  }

  @Override
  public boolean isLockStep() {
    return exact.isLockStep();
  }
}
