package org.dfra.river.transport;

import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/** Pools of threads for calls, which may block for long. */
public final class DaemonPool {

  private DaemonPool() {}

  /**
   * Creates a pool of daemons that start on demand, run each task immediately, and end after half a
   * minute without one. If no thread can be started, a task is refused with an {@link
   * OutOfMemoryError}.
   *
   * @param name prefix of the threads' names; a number follows
   */
  public static ThreadPoolExecutor create(String name) {
    AtomicInteger count = new AtomicInteger();
    return new ThreadPoolExecutor(
        0,
        Integer.MAX_VALUE,
        30,
        TimeUnit.SECONDS,
        new SynchronousQueue<>(),
        task -> {
          Thread thread = new Thread(task, name + count.incrementAndGet());
          thread.setDaemon(true);
          return thread;
        });
  }
}
