package org.dfra.sim.time;

import java.util.concurrent.locks.Condition;
import org.dfra.sim.time.Agenda.Due;
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
 * <p>A daemon. Whoever started it has it end, by the means of its role; {@link Baton} gives it the
 * turns for that.
 */
final class SteppedThread extends Thread {

  /** Where it is in the picture above. */
  enum Phase {
    /** Awaits its start. */
    NEW,
    /** Awaits its turn: that something comes, or that a time comes. */
    WAITING,
    /** Works; everybody else waits for it. */
    AT_WORK,
    /** Awaits nothing any more. */
    ENDED
  }

  private final Baton baton;
  private final Runnable role;

  // all guarded by the baton's lock
  final Condition turn;
  Phase phase = Phase.NEW;
  @Nullable Due wake; // when it waits for a time

  SteppedThread(Baton baton, String name, Runnable role) {
    super(name);
    this.baton = baton;
    this.role = role;
    this.turn = baton.newTurn();
    setDaemon(true);
  }

  boolean belongsTo(Baton other) {
    return baton == other;
  }

  /** Has its first turn soon, when the time is moved on. */
  @Override
  public void start() {
    super.start(); // throws when it was started before
    baton.begin(this);
  }

  @Override
  public void run() {
    baton.awaitFirstTurn(this);
    try {
      role.run();
    } finally {
      baton.end(this);
    }
  }

  /** {@inheritDoc} One that waits has its turn at once, so that it sees it. */
  @Override
  public void interrupt() {
    super.interrupt();
    baton.hasten(this);
  }
}
