package org.dfra.river.transport;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.lang.System.Logger.Level;
import java.util.ArrayDeque;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.ThreadPoolExecutor;
import org.jspecify.annotations.Nullable;

/**
 * Handshakes that can go on: their next bytes have arrived. A few threads take a step of one each,
 * of the addresses in turn, so that a flood from one address delays another's by one step.
 * Thread-safe.
 *
 * <p>Threads: {@code dfra-handshake-}number, or {@code dfra-stop-handshake-}number for connections
 * that are for a stop. They end after half a minute without work.
 */
final class HandshakeQueue {

  private static final System.Logger LOG = System.getLogger(HandshakeQueue.class.getName());

  private final ThreadPoolExecutor threads;
  private final int most;

  @GuardedBy("this")
  private final Map<Object, ArrayDeque<Runnable>> waiting = new LinkedHashMap<>(); // by origin

  @GuardedBy("this")
  private int running;

  /**
   * @param name prefix of the threads' names
   * @param most threads
   */
  HandshakeQueue(String name, int most) {
    this.threads = DaemonPool.create(name);
    this.most = most;
  }

  /**
   * Takes the next step of a handshake when it is its turn.
   *
   * @param origin whose turn it uses
   * @param step never waits, and reports its own failures
   */
  void add(Object origin, Runnable step) {
    synchronized (this) {
      waiting.computeIfAbsent(origin, unused -> new ArrayDeque<>()).add(step);
      if (running >= most) {
        return;
      }
      running++;
    }
    boolean isStarted = false;
    try {
      threads.execute(this::run);
      isStarted = true;
    } finally {
      if (!isStarted) {
        end();
      }
    }
  }

  private synchronized void end() {
    running--;
  }

  private void run() {
    for (Runnable step = next(); step != null; step = next()) {
      try {
        step.run();
      } catch (RuntimeException | Error e) { // the others need this thread
        LOG.log(Level.WARNING, "A step of a handshake failed.", e);
      }
    }
  }

  /** The next step; null if the thread is to end. */
  private synchronized @Nullable Runnable next() {
    if (waiting.isEmpty()) {
      running--;
      return null;
    }
    Map.Entry<Object, ArrayDeque<Runnable>> first = waiting.entrySet().iterator().next();
    Object origin = first.getKey();
    ArrayDeque<Runnable> its = first.getValue();
    waiting.remove(origin);
    Runnable step = its.remove();
    if (!its.isEmpty()) {
      waiting.put(origin, its); // behind the others
    }
    return step;
  }
}
