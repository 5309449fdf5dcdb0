package org.dfra.core.chain;

import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.dfra.core.time.BoundedThreads;
import org.dfra.time.Scheduler;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Subscribes to input modules, to several at the same time: one that does not answer delays no
 * other. In lock-step the tasks run on the scheduler, one after the other.
 *
 * <p>Threads: at most {@value #MOST} daemons for all modules of this virtual machine, {@code
 * dfra-subscribe-n}, and as many for what had failed, {@code dfra-resubscribe-n}, so that inputs
 * that do not answer delay no new one. They end when idle.
 */
final class SubscriptionExecutor {

  private static final Logger LOG = LoggerFactory.getLogger(SubscriptionExecutor.class);

  /** The largest number of threads. */
  static final int MOST = 32;

  private static final int IDLE_SECONDS = 10;
  private static final long RETRY_NANOS = TimeUnit.MILLISECONDS.toNanos(500);
  private static final ThreadPoolExecutor THREADS =
      BoundedThreads.create("dfra-subscribe-", MOST, IDLE_SECONDS);

  private static final ThreadPoolExecutor REPEATS =
      BoundedThreads.create("dfra-resubscribe-", MOST, IDLE_SECONDS);

  private final Scheduler scheduler;

  SubscriptionExecutor(Scheduler scheduler) {
    this.scheduler = scheduler;
  }

  /** Runs a task soon, with the context class loader of this call. */
  void execute(Runnable task) {
    if (scheduler.isLockStep()) {
      task.run();
    } else {
      start(withLoaderOfCaller(task), THREADS);
    }
  }

  /** Repeats a task after a delay, with the context class loader of this call. */
  void schedule(long nanos, Runnable task) {
    Runnable due = scheduler.isLockStep() ? task : withLoaderOfCaller(task);
    Scheduler.ScheduledTask unused =
        scheduler.after(nanos, scheduler.isLockStep() ? due : () -> start(due, REPEATS));
  }

  private void start(Runnable task, ThreadPoolExecutor threads) {
    try {
      threads.execute(task);
    } catch (OutOfMemoryError e) { // no further thread
      LOG.warn("Input modules cannot be subscribed to now; this is tried again: {}", e.toString());
      Scheduler.ScheduledTask unused = scheduler.after(RETRY_NANOS, () -> start(task, threads));
    }
  }

  private static Runnable withLoaderOfCaller(Runnable task) {
    ClassLoader loader = Thread.currentThread().getContextClassLoader();
    return () -> {
      Thread thread = Thread.currentThread();
      thread.setContextClassLoader(loader);
      try {
        task.run();
      } finally {
        thread.setContextClassLoader(null);
      }
    };
  }
}
