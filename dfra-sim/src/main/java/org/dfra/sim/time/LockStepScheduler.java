package org.dfra.sim.time;

import java.time.Duration;
import java.util.concurrent.locks.Condition;
import org.dfra.sim.time.EventQueue.ScheduledEvent;
import org.dfra.sim.time.SteppedThread.Phase;
import org.jspecify.annotations.Nullable;

/**
 * Runs one thread at a time. The thread with the execution right passes it to a waiting {@link
 * SteppedThread} and regains it when that thread waits again or has ended.
 */
final class LockStepScheduler {

  /** One wait of one thread. */
  static final class Wait {
    private boolean over; // guarded by the queue's lock
    private @Nullable SteppedThread thread; // guarded by the queue's lock; null for an outsider
  }

  private final EventQueue queue;
  private final Duration stuckTimeout;
  private final Condition givenBack;
  private final Condition outsideOver;
  private @Nullable SteppedThread overdue; // guarded by the queue's lock

  /**
   * @param patience real time that a thread may run before it is reported as stuck
   */
  LockStepScheduler(EventQueue queue, Duration patience) {
    this.queue = queue;
    this.stuckTimeout = patience;
    this.givenBack = queue.lock.newCondition();
    this.outsideOver = queue.lock.newCondition();
  }

  Condition newTurn() {
    return queue.lock.newCondition();
  }

  /** A thread was started: schedules it for the first time. */
  void register(SteppedThread thread) {
    queue.lock.lock();
    try {
      thread.phase = Phase.WAITING;
      wakeAt(thread, queue.now());
    } finally {
      queue.lock.unlock();
    }
  }

  void awaitFirstTurn(SteppedThread thread) {
    queue.lock.lock();
    try {
      awaitTurn(thread);
    } finally {
      queue.lock.unlock();
    }
  }

  /** A thread has ended and is not scheduled again. */
  void end(SteppedThread thread) {
    queue.lock.lock();
    try {
      thread.phase = Phase.TERMINATED;
      givenBack.signalAll();
    } finally {
      queue.lock.unlock();
    }
  }

  boolean isOver(Wait wait) {
    queue.lock.lock();
    try {
      return wait.over;
    } finally {
      queue.lock.unlock();
    }
  }

  /** Signals the event that a thread waits for. */
  void end(Wait wait) {
    queue.lock.lock();
    try {
      wait.over = true;
      if (wait.thread != null) {
        wakeNow(wait.thread);
      }
      outsideOver.signalAll();
    } finally {
      queue.lock.unlock();
    }
  }

  /** Schedules a waiting thread at this instant, before its wait ends. */
  void wakeNow(SteppedThread thread) {
    queue.lock.lock();
    try {
      ScheduledEvent wake = thread.wake;
      if (thread.phase == Phase.WAITING && (wake == null || wake.at() > queue.now())) {
        wakeAt(thread, queue.now());
      }
    } finally {
      queue.lock.unlock();
    }
  }

  private void wakeAt(SteppedThread thread, long at) {
    if (thread.wake != null) {
      queue.remove(thread.wake);
    }
    thread.wake =
        at == EventQueue.NEVER ? null : queue.add(at, thread.getName(), () -> run(thread));
  }

  /** The calling thread yields the execution right until its wait ends. */
  void await(SteppedThread me, Wait wait, long until) {
    queue.lock.lock();
    try {
      if (wait.over || me.isInterrupted() || until <= queue.now()) {
        return;
      }
      wait.thread = me;
      wakeAt(me, until);
      me.phase = Phase.WAITING;
      givenBack.signalAll();
      awaitTurn(me);
    } finally {
      queue.lock.unlock();
    }
  }

  private static void awaitTurn(SteppedThread me) {
    while (me.phase != Phase.RUNNING) {
      me.mayRun.awaitUninterruptibly();
    }
  }

  /** A thread that is not stepped waits while others advance the time. */
  void awaitOutside(Wait wait, long until) throws InterruptedException {
    queue.lock.lockInterruptibly();
    try {
      ScheduledEvent end = queue.add(until, "an asker's wait", () -> end(wait));
      try {
        while (!wait.over) {
          outsideOver.await();
        }
      } finally {
        queue.remove(end);
      }
    } finally {
      queue.lock.unlock();
    }
  }

  /**
   * Passes the caller's execution right to a waiting thread; returns when it is regained.
   *
   * @throws LockStep.StuckThreadException if it is not regained within the patience
   */
  void run(SteppedThread thread) {
    if (!tryRun(thread, stuckTimeout.toNanos())) {
      throw new LockStep.StuckThreadException(thread, stuckTimeout);
    }
  }

  /** The same, with a patience in real nanoseconds; returns whether it was regained in time. */
  boolean tryRun(SteppedThread thread, long patienceNanos) {
    queue.lock.lock();
    try {
      if (thread.phase == Phase.WAITING) {
        if (thread.wake != null) {
          queue.remove(thread.wake);
          thread.wake = null;
        }
        thread.phase = Phase.RUNNING;
        thread.mayRun.signal();
      }
      return awaitBack(thread, patienceNanos);
    } finally {
      queue.lock.unlock();
    }
  }

  /**
   * Regains the execution right from a thread that did not yield in time.
   *
   * @throws LockStep.StuckThreadException if it does not yield now either
   */
  void reclaim() {
    queue.lock.lock();
    try {
      SteppedThread late = overdue;
      if (late != null && !awaitBack(late, stuckTimeout.toNanos())) {
        throw new LockStep.StuckThreadException(late, stuckTimeout);
      }
    } finally {
      queue.lock.unlock();
    }
  }

  private boolean awaitBack(SteppedThread thread, long patienceNanos) {
    boolean interrupted = false;
    long left = patienceNanos;
    while (thread.phase == Phase.RUNNING && left > 0) {
      try {
        left = givenBack.awaitNanos(left);
      } catch (InterruptedException e) {
        interrupted = true; // a granted execution right cannot be revoked
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
    boolean isBack = thread.phase != Phase.RUNNING;
    overdue = isBack ? null : thread;
    return isBack;
  }
}
