package org.dfra.core.behavior;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.util.Arrays;
import org.dfra.core.chain.DelayedTaskExecutor;
import org.dfra.time.Scheduler;
import org.dfra.time.Scheduler.ScheduledTask;
import org.jspecify.annotations.Nullable;

/**
 * Runs a task periodically at a fixed rate. A late cycle does not delay the next one, and missed
 * cycles are counted, not made up for.
 *
 * <p>Cycles never overlap. Except in lock-step they run on the loop's own thread, so they may
 * block.
 */
final class ControlLoop implements AutoCloseable {

  /** Cycles whose lateness is recorded. */
  private static final int REMEMBERED = 600;

  private final Scheduler time;
  private final long period;
  private final Runnable cycle;
  private final DelayedTaskExecutor thread;

  @GuardedBy("this")
  private boolean running;

  // nanos of the next cycle
  @GuardedBy("this")
  private long due;

  @GuardedBy("this")
  private @Nullable ScheduledTask next;

  // an outdated timer task does nothing
  @GuardedBy("this")
  private long beats;

  @GuardedBy("this")
  private long cycles;

  @GuardedBy("this")
  private long missed;

  // nanos
  @GuardedBy("this")
  private final long[] lateness = new long[REMEMBERED];

  /**
   * @param name name of its thread
   * @param time the clock of the rate: the robot's
   * @param rate cycles per second, hertz
   * @param cycle the task; an exception that it throws stops the loop, which may be started again
   */
  public ControlLoop(String name, Scheduler time, double rate, Runnable cycle) {
    this.time = time;
    this.period = Math.round(1e9 / rate);
    this.cycle = cycle;
    this.thread = new DelayedTaskExecutor(name, time);
  }

  /** Starts the loop with a cycle at once. Does nothing while it runs. */
  public synchronized void start() {
    if (!running) {
      running = true;
      due = time.nanos();
      schedule();
    }
  }

  /** Stops the loop after the cycle in progress. */
  public synchronized void stop() {
    running = false;
    beats++;
    if (next != null) {
      next.cancel();
      next = null;
    }
  }

  private synchronized void stop(long beat) {
    if (beat == beats) {
      stop();
    }
  }

  private synchronized void schedule() {
    long beat = ++beats;
    next = time.after(due - time.nanos(), () -> thread.execute(() -> runCycle(beat)));
  }

  private void runCycle(long beat) {
    synchronized (this) {
      if (!running || beat != beats) {
        return;
      }
      lateness[(int) (cycles % REMEMBERED)] = time.nanos() - due;
      cycles++;
    }
    boolean isDone = false;
    try {
      cycle.run();
      isDone = true;
    } finally {
      if (!isDone) {
        stop(beat);
      }
    }
    synchronized (this) {
      if (!running || beat != beats) {
        return;
      }
      due += period;
      long behind = time.nanos() - due;
      if (behind > 0) {
        long skipped = behind / period;
        missed += skipped;
        due += skipped * period;
      }
      schedule();
    }
  }

  /** Cycles so far. */
  public synchronized long cycles() {
    return cycles;
  }

  /** Cycles that were missed because earlier ones took too long. */
  public synchronized long missedCycles() {
    return missed;
  }

  /**
   * A quantile of the lateness of the last 600 cycles, in seconds; 0 before the first.
   *
   * @param share the quantile, 0 to 1
   */
  public synchronized double lateness(double share) {
    int known = (int) Math.min(cycles, REMEMBERED);
    if (known == 0) {
      return 0;
    }
    long[] sorted = Arrays.copyOf(lateness, known);
    Arrays.sort(sorted);
    return sorted[(int) Math.max(0, Math.ceil(share * known) - 1)] / 1e9;
  }

  /** Ends the loop and its thread. */
  @Override
  public void close() {
    stop();
    thread.close();
  }
}
