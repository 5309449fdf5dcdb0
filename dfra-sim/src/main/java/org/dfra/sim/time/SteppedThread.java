package org.dfra.sim.time;

import java.util.concurrent.locks.Condition;
import org.dfra.sim.time.EventQueue.ScheduledEvent;
import org.jspecify.annotations.Nullable;

/**
 * A thread that works only when it is its turn.
 *
 * <pre>
 *   NEW --start()--&gt; WAITING --its turn--&gt; AT_WORK --its role returns--&gt; ENDED
 *                       ^                     |
 *                       '------- waits -------'
 * </pre>
 *
 * <p>A daemon. Whoever started it has it end, by the means of its role; {@link LockStepScheduler}
 * gives it the turns for that.
 */
final class SteppedThread extends Thread {

  /** Where it is in the picture above. */
  enum Phase {
    /** Awaits its start. */
    NEW,
    /** Awaits its turn: that something comes, or that a time comes. */
    WAITING,
    /** Works; everybody else waits for it. */
    RUNNING,
    /** Awaits nothing any more. */
    TERMINATED
  }

  private final LockStepScheduler scheduler;
  private final Runnable role;

  // all guarded by the baton's lock
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

  /** Has its first turn soon, when the time is moved on. */
  @Override
  public void start() {
    super.start(); // throws when it was started before
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

  /** {@inheritDoc} One that waits has its turn at once, so that it sees it. */
  @Override
  public void interrupt() {
    super.interrupt();
    scheduler.wakeNow(this);
  }
}
