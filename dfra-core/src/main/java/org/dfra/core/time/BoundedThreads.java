package org.dfra.core.time;

import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/** Pools with a limited number of threads, for tasks that may wait for other computers. */
public final class BoundedThreads {

  private BoundedThreads() {}

  /**
   * A pool of daemons that start on demand and end when idle. If all are busy, tasks wait in order.
   * If no thread can be started, a task is refused with an {@link OutOfMemoryError}.
   *
   * @param name prefix of the threads' names; a number follows
   * @param most largest number of threads
   * @param idleSeconds how long a thread waits for a task, seconds
   */
  public static ThreadPoolExecutor create(String name, int most, int idleSeconds) {
    AtomicInteger number = new AtomicInteger();
    ThreadPoolExecutor threads =
        new ThreadPoolExecutor(
            most,
            most,
            idleSeconds,
            TimeUnit.SECONDS,
            new LinkedBlockingQueue<>(),
            task -> {
              Thread thread = new Thread(task, name + number.incrementAndGet());
              thread.setDaemon(true);
              return thread;
            });
    threads.allowCoreThreadTimeOut(true);
    return threads;
  }
}
