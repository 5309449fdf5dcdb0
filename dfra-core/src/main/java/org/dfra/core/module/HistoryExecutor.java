package org.dfra.core.module;

import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * The thread that writes histories to the disk, so that no driver waits for the disk: one daemon
 * for all modules of this virtual machine, {@code dfra-history}, which ends when idle.
 */
final class HistoryExecutor {

  private static final Executor SHARED = executor();

  private HistoryExecutor() {}

  /** The executor of this virtual machine. */
  static Executor shared() {
    return SHARED;
  }

  private static Executor executor() {
    ThreadPoolExecutor executor =
        new ThreadPoolExecutor(
            1,
            1,
            10,
            TimeUnit.SECONDS,
            new LinkedBlockingQueue<>(),
            task -> {
              Thread thread = new Thread(task, "dfra-history");
              thread.setDaemon(true);
              thread.setContextClassLoader(null);
              return thread;
            });
    executor.allowCoreThreadTimeOut(true);
    return executor;
  }
}
