package org.dfra.sim.time;

import java.util.concurrent.locks.Condition;
import org.dfra.sim.time.EventQueue.ScheduledEvent;
import org.jspecify.annotations.Nullable;

/**
 * A thread that runs only when the {@link LockStepScheduler} schedules it.
 *
 * <pre>
 *   NEW --start()--&gt; WAITING --scheduled--&gt; RUNNING --its role returns--&gt; TERMINATED
 *                       ^                      |
 *                       '------- waits --------'
 * </pre>
 *
 * <p>A daemon thread. Its creator ends it by the means of its role; {@link LockStepScheduler}
 * schedules it for that.
 */
final class SteppedThread extends Thread {

  /** Its state in the diagram above. */
  enum Phase {
    /** Not started. */
    NEW,
    /** Waits for a signal or a time. */
    WAITING,
    /** Runs; all other threads wait for it. */
    RUNNING,
    /** Has ended. */
    TERMINATED
  }

  private final LockStepScheduler scheduler;
  private final Runnable role;

  // all guarded by the scheduler's lock
  final Condition mayRun;
  Phase phase = Phase.NEW;
  @Nullable ScheduledEvent wake; // when it waits for a time

  SteppedThread(LockStepScheduler stuckTurn, String name, Runnable role) {
    super(name);
    this.scheduler = stuckTurn;
    this.role = role;
    this.mayRun = stuckTurn.newTurn();
    setDaemon(true);
  }

  boolean belongsTo(LockStepScheduler other) {
    return scheduler == other;
  }

  /** It runs first at the next advance of the time. */
  @Override
  public void start() {
    super.start(); // throws if already started
    scheduler.register(this);
  }

  @Override
  public void run() {
    scheduler.awaitFirstTurn(this);
    try {
      role.run();
    } finally {
      scheduler.end(this);
    }
  }

  /** {@inheritDoc} A waiting thread is scheduled at once, so that it detects the interrupt. */
  @Override
  public void interrupt() {
    super.interrupt();
    scheduler.wakeNow(this);
  }
}
