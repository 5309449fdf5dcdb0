package org.dfra.river.call;

import java.util.concurrent.FutureTask;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * The threads on which remote calls wait for their answers.
 *
 * <p>JERI can block in places that no caller can interrupt (connecting, the handshake of its
 * multiplexer), so the caller waits beside the call, not in it. The threads are daemons, are made
 * as calls need them and end after half a minute without one. What else calls from a timer has a
 * {@link #pool} of the same make.
 */
public final class CallThreads {

  private static final ThreadPoolExecutor POOL = pool("dfra-call-");

  private CallThreads() {}

  /**
   * Daemons that are made as tasks need them, each task at once, and end after half a minute
   * without one. A task is refused by an {@link OutOfMemoryError} where no thread can be started.
   *
   * @param name how their names begin; a number follows
   */
  public static ThreadPoolExecutor pool(String name) {
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

  /** Runs the task at once, on a thread of its own that sees the caller's context class loader. */
  static void run(FutureTask<?> task) {
    ClassLoader loader = Thread.currentThread().getContextClassLoader();
    POOL.execute(
        () -> {
          Thread thread = Thread.currentThread();
          thread.setContextClassLoader(loader);
          try {
            task.run();
          } finally {
            thread.setContextClassLoader(null);
          }
        });
  }
}
