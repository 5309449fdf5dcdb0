package org.dfra.river.lookup;

import com.sun.jini.thread.TaskManager;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;

/**
 * The threads that register a module. Ended, they finish what they are at.
 *
 * <p>River's own are interrupted. A call that is interrupted on its way leaves behind a
 * registration that nobody knows of: the lookup service goes on and makes it.
 *
 * <p>The threads are daemons, are started by tasks and end after a quarter of a minute without one.
 */
final class RegistrationExecutor extends TaskManager {

  private static final int MOST = 15;
  private static final long IDLE_MILLIS = 15_000;

  /** One thread for each task, so that a lookup service that is silent holds up no other. */
  RegistrationExecutor() {
    super(MOST, IDLE_MILLIS, 1.0f);
  }

  /** Begins no other task. */
  @Override
  public synchronized void terminate() {
    terminated = true;
    notifyAll(); // those that wait for a task
  }

  /**
   * Waits until the last task has ended.
   *
   * @param timeout how long at the longest; not at all where it is negative
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
