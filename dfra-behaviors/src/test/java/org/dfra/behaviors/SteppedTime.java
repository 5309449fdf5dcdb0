package org.dfra.behaviors;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Comparator;
import java.util.PriorityQueue;
import java.util.function.BooleanSupplier;
import org.dfra.time.Scheduler;

/** Clock and scheduler of a test, in lock-step: all happens on the test's thread, when stepped. */
public final class SteppedTime implements InstantSource, Scheduler {

  private static final Instant BEGIN = Instant.parse("2026-11-21T12:00:00Z");

  private record Due(long at, long number, Runnable task) {}

  private final PriorityQueue<Due> tasks =
      new PriorityQueue<>(Comparator.comparingLong(Due::at).thenComparingLong(Due::number));
  private long now;
  private long number;

  @Override
  public Instant instant() {
    return BEGIN.plusNanos(now);
  }

  @Override
  public long nanos() {
    return now;
  }

  @Override
  public ScheduledTask after(long nanos, Runnable task) {
    Due due = new Due(now + Math.max(0, nanos), number++, task);
    tasks.add(due);
    return () -> tasks.remove(due);
  }

  @Override
  public boolean isLockStep() {
    return true;
  }

  /** Has everything happen that is due within so many seconds. */
  public void step(double seconds) {
    boolean unused = until(() -> false, seconds);
  }

  /**
   * The same, until something holds.
   *
   * @return whether it does
   */
  public boolean until(BooleanSupplier condition, double seconds) {
    long end = now + Duration.ofNanos(Math.round(seconds * 1e9)).toNanos();
    while (!condition.getAsBoolean()) {
      Due next = tasks.peek();
      if (next == null || next.at() > end) {
        now = end;
        return condition.getAsBoolean();
      }
      tasks.remove(next);
      now = next.at();
      next.task().run();
    }
    return true;
  }
}
