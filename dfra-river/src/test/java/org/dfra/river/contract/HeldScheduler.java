package org.dfra.river.contract;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Queue;
import org.dfra.time.Scheduler;

/**
 * Real time, but what is due soon waits until the test lets it: a drive's watch, so that a machine
 * that is slow halts no wheels. Leases last longer and end by themselves.
 */
final class HeldScheduler implements Scheduler {

  private static final long SOON_NANOS = Duration.ofMillis(60).toNanos();

  private final Scheduler real = Scheduler.system();
  private final Queue<Runnable> held = new ArrayDeque<>(); // guarded by itself

  @Override
  public long nanos() {
    return real.nanos();
  }

  @Override
  public ScheduledTask after(long nanos, Runnable task) {
    if (nanos > SOON_NANOS) {
      return real.after(nanos, task);
    }
    synchronized (held) {
      held.add(task);
    }
    return () -> {
      synchronized (held) {
        held.remove(task);
      }
    };
  }

  /** Lets what has been held be done, on this thread. */
  void release() {
    Queue<Runnable> due;
    synchronized (held) {
      due = new ArrayDeque<>(held);
      held.clear();
    }
    due.forEach(Runnable::run);
  }
}
