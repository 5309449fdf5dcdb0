package org.dfra.core.chain;

import java.util.Arrays;
import org.dfra.time.Scheduler;
import org.dfra.time.Scheduler.ScheduledTask;
import org.jspecify.annotations.Nullable;

/**
 * Does one thing again and again, at a rate. It keeps to the rate: one turn that is late does not
 * make the next one late, and turns that were missed altogether are counted, not made up for.
 *
 * <p>Turns never overlap. Elsewhere than in lock-step they are on a thread of the loop's own, so
 * they may wait for others.
 */
public final class ControlLoop implements AutoCloseable {

  /** Turns whose lateness is remembered. */
  private static final int REMEMBERED = 600;

  private final Scheduler time;
  private final long period;
  private final Runnable cycle;
  private final DelayedTaskExecutor thread;

  private boolean running; // guarded by this
  private long due; // guarded by this; nanos of the next turn
  private @Nullable ScheduledTask next; // guarded by this
  private long beats; // guarded by this; a beat that is not the last does nothing
  private long cycles; // guarded by this
  private long missed; // guarded by this
  private final long[] lateness = new long[REMEMBERED]; // guarded by this; nanos

  /**
   * @param name of its thread
   * @param time what the rate is reckoned by: the robot's
   * @param rate turns per second, hertz
   * @param cycle what to do; what it throws stops the loop, which may be started again
   */
  public ControlLoop(String name, Scheduler time, double rate, Runnable cycle) {
    this.time = time;
    this.period = Math.round(1e9 / rate);
    this.cycle = cycle;
    this.thread = new DelayedTaskExecutor(name, time);
  }

  /** Begins, with a turn at once. Does nothing while it runs. */
  public synchronized void start() {
    if (!running) {
      running = true;
      due = time.nanos();
      schedule();
    }
  }

  /** Has no more turns, but for one that is under way. */
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

  /** Turns so far. */
  public synchronized long cycles() {
    return cycles;
  }

  /** Turns that were left out, since others took too long. */
  public synchronized long missedCycles() {
    return missed;
  }

  /**
   * The lateness, in seconds, that so many of the last 600 turns did not exceed; 0 before the
   * first.
   *
   * @param share of them, 0 to 1
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

  /** Ends it for good. */
  @Override
  public void close() {
    stop();
    thread.close();
  }
}
