package org.dfra.river.phoenix;

import java.time.Duration;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;

/**
 * The daemon's own threads. {@code phoenix-timer} (one) starts delayed tasks. {@code phoenix-work}
 * restart objects and wait for the exit of processes. They run as long as the daemon.
 */
final class DaemonExecutors {

  private final ScheduledExecutorService timer =
      Executors.newSingleThreadScheduledExecutor(task -> thread(task, "phoenix-timer"));
  private final ExecutorService work =
      Executors.newCachedThreadPool(task -> thread(task, "phoenix-work"));
  private volatile boolean ending;

  /** Runs a task after a delay, on the timer's thread. Discards it if the daemon shuts down. */
  void after(Duration delay, Runnable task) {
    if (!ending) {
      timer.schedule(task, delay.toNanos(), TimeUnit.NANOSECONDS);
    }
  }

  /** Runs a task that may take long. */
  void execute(Runnable task) {
    work.execute(task);
  }

  /** Discards all later tasks: the daemon is shutting down. */
  void stopScheduling() {
    ending = true;
  }

  /** Stops the threads. */
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
