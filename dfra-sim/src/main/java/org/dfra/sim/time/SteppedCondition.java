package org.dfra.sim.time;

import java.util.ArrayDeque;
import java.util.Date;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.dfra.sim.time.LockStepScheduler.Wait;

/** A condition whose waits end on a signal or at a time of a {@link LockStep}. */
final class SteppedCondition implements Condition {

  private final LockStep time;
  private final LockStepScheduler scheduler;
  private final ReentrantLock lock;
  private final ArrayDeque<Wait> waits = new ArrayDeque<>(); // guarded by lock

  SteppedCondition(LockStep time, LockStepScheduler stuckTurn, ReentrantLock lock) {
    this.time = time;
    this.scheduler = stuckTurn;
    this.lock = lock;
  }

  boolean belongsTo(LockStep other) {
    return time == other;
  }

  /** Waits until signalled, or until a time of the lock-step; may return early. */
  void await(long until) throws InterruptedException {
    requireLock();
    Wait wait = new Wait();
    waits.add(wait);
    int holds = lock.getHoldCount();
    for (int i = 0; i < holds; i++) {
      lock.unlock();
    }
    try {
      time.await(wait, until);
    } finally {
      for (int i = 0; i < holds; i++) {
        lock.lock();
      }
      waits.remove(wait);
    }
  }

  @Override
  public void await() throws InterruptedException {
    await(EventQueue.NEVER);
  }

  @Override
  public void awaitUninterruptibly() {
    throw new UnsupportedOperationException(
        "simulated time needs a timeout for each wait; use Ticker.await");
  }

  @Override
  public long awaitNanos(long nanos) throws InterruptedException {
    long end = time.timeAfter(nanos);
    if (nanos > 0) {
      await(end);
    }
    return end - time.nanos();
  }

  @Override
  public boolean await(long duration, TimeUnit unit) throws InterruptedException {
    return awaitNanos(unit.toNanos(duration)) > 0;
  }

  @Override
  public boolean awaitUntil(Date deadline) {
    throw new UnsupportedOperationException(
        "a date is in real time; use Ticker.await with a number of nanoseconds");
  }

  @Override
  public void signal() {
    requireLock();
    Wait first = waits.poll();
    if (first != null) {
      scheduler.end(first);
    }
  }

  @Override
  public void signalAll() {
    requireLock();
    while (!waits.isEmpty()) {
      signal();
    }
  }

  private void requireLock() {
    if (!lock.isHeldByCurrentThread()) {
      throw new IllegalMonitorStateException(
          Thread.currentThread().getName() + " does not hold the condition's lock");
    }
  }
}
