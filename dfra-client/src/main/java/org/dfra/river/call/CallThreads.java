package org.dfra.river.call;

import java.util.concurrent.FutureTask;
import java.util.concurrent.ThreadPoolExecutor;
import org.dfra.river.transport.DaemonPool;

/**
 * The threads on which remote calls wait for their responses.
 *
 * <p>JERI can block in places that no caller can interrupt (connecting, the handshake of its
 * multiplexer). So the call runs on its own thread, and the caller waits for that thread. The
 * threads are daemons, start on demand and end after half a minute without a call. Other calls from
 * timers use a {@link #pool} of the same kind.
 */
public final class CallThreads {

  private static final ThreadPoolExecutor POOL = pool("dfra-call-");

  private CallThreads() {}

  /**
   * A pool of the same kind, for other calls; see {@link DaemonPool#create}.
   *
   * @param name prefix of the threads' names; a number follows
   */
  public static ThreadPoolExecutor pool(String name) {
    return DaemonPool.create(name);
  }

  /** Runs the task immediately, on its own thread with the caller's context class loader. */
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
