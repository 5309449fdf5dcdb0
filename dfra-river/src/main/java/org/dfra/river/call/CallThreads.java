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
 * as calls need them and end after half a minute without one.
 */
final class CallThreads {

  private static final AtomicInteger COUNT = new AtomicInteger();

  private static final ThreadPoolExecutor POOL =
      new ThreadPoolExecutor(
          0,
          Integer.MAX_VALUE,
          30,
          TimeUnit.SECONDS,
          new SynchronousQueue<>(),
          task -> {
            Thread thread = new Thread(task, "dfra-call-" + COUNT.incrementAndGet());
            thread.setDaemon(true);
            return thread;
          });

  private CallThreads() {}

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
