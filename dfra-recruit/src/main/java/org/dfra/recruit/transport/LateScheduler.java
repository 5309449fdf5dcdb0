package org.dfra.recruit.transport;

import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.random.RandomGenerator;
import org.dfra.time.Scheduler;

/** Another scheduler whose tasks run a little late, as a busy computer's do. */
public final class LateScheduler implements Scheduler {

  private final Scheduler exact;
  private final DelayModel late;
  private final RandomGenerator lot;

  /**
   * @param delay by how much each task is
   * @param random what that is drawn by
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
