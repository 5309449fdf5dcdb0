package org.dfra.time;

import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/** A monotonic clock in nanoseconds, and timers on it. Tests step it. */
public interface Scheduler {

  /** The time in nanoseconds from an arbitrary origin; only differences are meaningful. */
  long nanos();

  /**
   * Runs a task once, after a delay.
   *
   * @param task must not block: all tasks share one thread
   * @param nanos the delay; none if not positive
   */
  ScheduledTask after(long nanos, Runnable task);

  /**
   * The same clock, with a timer that runs only command timeouts, so that no other task can delay
   * them. Its tasks take no lock that a driver may hold: they only hand over to a thread of the
   * effector.
   */
  default Scheduler commandTimer() {
    return this;
  }

  /** A condition of {@code lock} whose {@code awaitNanos} uses this clock. */
  default Condition newCondition(ReentrantLock lock) {
    return lock.newCondition();
  }

  /** A scheduled task. */
  @FunctionalInterface
  interface ScheduledTask {

    /** Cancels the task. It may still run if it is about to. */
    void cancel();
  }

  /**
   * Whether this is the clock of a lock-step simulation. Then all observable work must run in its
   * tasks, including work that otherwise runs on a thread pool.
   */
  default boolean isLockStep() {
    return false;
  }

  /**
   * The computer's monotonic time; its tasks run on one daemon thread, {@code dfra-timer}, and
   * those of its {@link #commandTimer} on another, {@code dfra-command-timer}.
   */
  static Scheduler system() {
    return SystemScheduler.INSTANCE;
  }
}
