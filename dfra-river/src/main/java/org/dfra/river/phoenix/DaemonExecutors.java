package org.dfra.river.phoenix;

import java.time.Duration;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;

/**
 * The daemon's own threads: {@code phoenix-timer} (one) starts what is due later, {@code
 * phoenix-work} restart objects and wait for the end of processes. They are there as long as the
 * daemon is.
 */
final class DaemonExecutors {

  private final ScheduledExecutorService timer =
      Executors.newSingleThreadScheduledExecutor(task -> thread(task, "phoenix-timer"));
  private final ExecutorService work =
      Executors.newCachedThreadPool(task -> thread(task, "phoenix-work"));
  private volatile boolean ending;

  /** Runs a task after a delay, on the timer's thread; never where the daemon ends. */
  void after(Duration delay, Runnable task) {
    if (!ending) {
      timer.schedule(task, delay.toNanos(), TimeUnit.NANOSECONDS);
    }
  }

  /** Runs a task that may take long. */
  void execute(Runnable task) {
    work.execute(task);
  }

  /** Nothing more is planned: the daemon ends. */
  void stopScheduling() {
    ending = true;
  }

  /** Ends the threads. */
  void stop() {
    timer.shutdownNow();
    work.shutdownNow();
  }

  private static Thread thread(Runnable task, String name) {
    Thread thread = new Thread(task, name);
    thread.setDaemon(true);
    return thread;
  }
}
