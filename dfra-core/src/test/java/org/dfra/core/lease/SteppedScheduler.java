package org.dfra.core.lease;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.dfra.time.Scheduler;

/** Time that the test steps; what is due runs on the test's thread. */
public final class SteppedScheduler implements Scheduler {

  private record Due(long at, Runnable task) {}

  private final List<Due> tasks = new ArrayList<>();
  private long now = Long.MAX_VALUE - 1_000_000_000L; // overflows soon

  @Override
  public synchronized long nanos() {
    return now;
  }

  @Override
  public synchronized ScheduledTask after(long nanos, Runnable task) {
    Due due = new Due(now + nanos, task);
    tasks.add(due);
    return () -> cancel(due);
  }

  private synchronized void cancel(Due due) {
    tasks.remove(due);
  }

  @Override
  public boolean isLockStep() {
    return true; // no thread but the test's
  }

  public void step(Duration duration) {
    List<Due> due;
    synchronized (this) {
      now += duration.toNanos();
      due = new ArrayList<>(tasks.stream().filter(task -> task.at() - now <= 0).toList());
      due.sort(Comparator.comparingLong(task -> task.at() - now));
      tasks.removeAll(due);
    }
    due.forEach(task -> task.task().run());
  }

  public synchronized int waiting() {
    return tasks.size();
  }
}
