package org.dfra.river.lookup;

import com.sun.jini.thread.TaskManager;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;

/**
 * The threads that register a module. After termination, running tasks complete.
 *
 * <p>River's own threads are interrupted. An interrupted call leaves behind an unknown
 * registration: the lookup service still makes it.
 *
 * <p>The threads are daemons. Tasks start them, and they end after 15 s without a task.
 */
final class RegistrationExecutor extends TaskManager {

  private static final int MOST = 15;
  private static final long IDLE_MILLIS = 15_000;

  /** One thread for each task, so that a lookup service that does not answer blocks no other. */
  RegistrationExecutor() {
    super(MOST, IDLE_MILLIS, 1.0f);
  }

  /** Starts no further task. */
  @Override
  public synchronized void terminate() {
    terminated = true;
    notifyAll(); // those that wait for a task
  }

  /**
   * Waits for the last task.
   *
   * @param timeout the longest wait; none if negative
   * @throws InterruptedException if the waiting thread is interrupted
   */
  void awaitEnd(Duration timeout) throws InterruptedException {
    long deadline = System.nanoTime() + timeout.toNanos();
    for (Thread thread : running()) {
      long millis = (deadline - System.nanoTime()) / 1_000_000;
      if (millis > 0 && thread != Thread.currentThread()) {
        thread.join(millis);
      }
    }
  }

  @SuppressWarnings("unchecked") // River's list has no type; its elements are threads
  private synchronized List<Thread> running() {
    return new ArrayList<>(threads);
  }
}
