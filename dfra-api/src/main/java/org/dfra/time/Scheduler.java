package org.dfra.time;

import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/**
 * Time for what must happen later: a count of nanoseconds that nobody sets, and a way to be called
 * back. Tests step it.
 */
public interface Scheduler {

  /** The time in nanoseconds from an arbitrary origin; only differences mean something. */
  long nanos();

  /**
   * Runs a task once, after a while.
   *
   * @param task must not block: all tasks share one thread
   * @param nanos how long to wait; not at all when not positive
   */
  ScheduledTask after(long nanos, Runnable task);

  /**
   * The same time, by a timer that runs nothing but command time-outs, so that nothing else can
   * make them late. Its tasks take no lock that a driver may hold: they only hand over to a thread
   * of the effector's own.
   */
  default Scheduler commandTimer() {
    return this;
  }

  /** A condition of {@code lock} whose {@code awaitNanos} goes by this time. */
  default Condition newCondition(ReentrantLock lock) {
    return lock.newCondition();
  }

  /** Something that will be run. */
  @FunctionalInterface
  interface ScheduledTask {

    /** It need not be run any more. It may still be, if it is about to. */
    void cancel();
  }

  /**
   * Whether this is the time of a simulation in lock-step. Then nothing may happen beside its tasks
   * that others could notice, so what else would be left to a pool of threads is one of them.
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
