package org.dfra.recruit.transport;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Comparator;
import java.util.PriorityQueue;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.random.RandomGenerator;
import org.dfra.time.Scheduler;

/**
 * Virtual time that advances only on request: clock and scheduler in one. Tasks due at the same
 * instant run in the order of their submission. Confined to one thread.
 */
public final class VirtualTime implements InstantSource, Scheduler {

  private static final class QueuedTask implements ScheduledTask {
    final long at;
    final long number;
    final Runnable task;
    boolean isCancelled;

    QueuedTask(long at, long number, Runnable task) {
      this.at = at;
      this.number = number;
      this.task = task;
    }

    @Override
    public void cancel() {
      isCancelled = true;
    }
  }

  private final Instant begin;
  private final PriorityQueue<QueuedTask> queue =
      new PriorityQueue<>(
          Comparator.comparingLong((QueuedTask due) -> due.at)
              .thenComparingLong(due -> due.number));
  private long now;
  private long asked;

  /**
   * @param begin the first instant
   */
  public VirtualTime(Instant begin) {
    this.begin = begin;
  }

  @Override
  public Instant instant() {
    return begin.plusNanos(now);
  }

  /** Nanoseconds since the first instant. */
  @Override
  public long nanos() {
    return now;
  }

  /** Seconds since the first instant. */
  public double seconds() {
    return now / 1e9;
  }

  @Override
  public ScheduledTask after(long nanos, Runnable task) {
    long wait = Math.max(0, nanos);
    QueuedTask due =
        new QueuedTask(now > Long.MAX_VALUE - wait ? Long.MAX_VALUE : now + wait, asked++, task);
    queue.add(due);
    return due;
  }

  @Override
  public boolean isLockStep() {
    return true;
  }

  /** Runs all tasks due within the given time, end included. */
  public void advance(Duration span) {
    long end = now + span.toNanos();
    while (next(end)) {
      // each at its time
    }
    now = end;
  }

  /** Runs the next task due by a time; false where there is none. */
  private boolean next(long end) {
    QueuedTask due = queue.peek();
    while (due != null && due.isCancelled) {
      QueuedTask unused = queue.poll();
      due = queue.peek();
    }
    if (due == null || due.at > end) {
      return false;
    }
    QueuedTask unused = queue.poll();
    now = due.at;
    due.task.run();
    return true;
  }

  /** Wraps a scheduler; its tasks run slightly late, as on a busy computer. */
  public static final class LateScheduler implements Scheduler {

    private final Scheduler exact;
    private final DelayModel late;
    private final RandomGenerator random;

    /**
     * @param delay of each task
     * @param random source of random numbers
     */
    public LateScheduler(Scheduler exact, DelayModel delay, RandomGenerator random) {
      this.exact = exact;
      this.late = delay;
      this.random = random;
    }

    @Override
    public long nanos() {
      return exact.nanos();
    }

    @Override
    public ScheduledTask after(long nanos, Runnable task) {
      return exact.after(Math.max(0, nanos) + Math.round(late.next(random) * 1e9), task);
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
}
