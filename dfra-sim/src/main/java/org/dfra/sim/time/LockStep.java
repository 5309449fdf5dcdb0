package org.dfra.sim.time;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import org.dfra.drivers.link.SimLinkRegistry;
import org.dfra.drivers.link.Ticker;
import org.dfra.sim.time.EventQueue.ScheduledEvent;
import org.dfra.sim.time.LockStepScheduler.Wait;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/**
 * The time of a robot that is simulated bit-reproducibly: it stands until it is moved on, and while
 * it is, everything that is due happens one after the other, in an order that depends on nothing
 * but the program.
 *
 * <p>It is a module's clock and its scheduler ({@code new ModuleContext(robot, name, parameters,
 * time, state, leases, time)}); a driver's {@code Ticker.of(clock)} is then this time too. Threads
 * that such a ticker made, the drivers' readers, work only while it is moved on, one at a time: a
 * reader has its turn when bytes have come, its wait is over or somebody signals it, and the time
 * goes on when it waits again. Of things due at the same instant those come first that were entered
 * first; what is repeated keeps its place.
 *
 * <p>Whoever calls {@link #advance} is the stepper: tasks run on its thread. Other threads may ask
 * the modules at any time, but what they cause happens at an instant that nobody can repeat, unless
 * they ask between two steps. The stepper may use what waits (a module's examinations, say): the
 * time then goes on until it is done. Others that wait, wait until the stepper has gone so far.
 *
 * <p>No wall clock is read, except to notice a thread that has its turn and never waits again:
 * {@link StuckThreadException}.
 */
public final class LockStep implements InstantSource, Scheduler, Ticker {

  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final long POLL_INTERVAL_MILLIS = 10;

  private final Instant begin;
  private final EventQueue agenda = new EventQueue();
  private final LockStepScheduler scheduler;
  private final SimLinkRegistry links =
      new SimLinkRegistry(
          "the simulation has started none yet; org.dfra.sim.device.SimPort makes one");

  /** Held while the time is moved on. Taken before any other lock. */
  private final ReentrantLock stepping = new ReentrantLock();

  private volatile @Nullable Thread stepper;

  /** Time that begins at {@code begin}. */
  public LockStep(Instant begin) {
    this(begin, PATIENCE);
  }

  /**
   * @param begin the first instant
   * @param patience how long a thread may have its turn, in real time, before it counts as stuck
   */
  public LockStep(Instant begin, Duration patience) {
    this.begin = begin;
    this.scheduler = new LockStepScheduler(agenda, patience);
  }

  @Override
  public Instant instant() {
    return begin.plusNanos(agenda.now());
  }

  /** Nanoseconds since the first instant. */
  @Override
  public long nanos() {
    return agenda.now();
  }

  /**
   * Moves the time on, and has everything happen that is due until then, or due then.
   *
   * @throws StuckThreadException if a reader does not come back to wait
   * @throws IllegalStateException if a task or a reader calls this, or if more and more happens at
   *     one instant
   * @throws RuntimeException what a task throws; the time stands where it did
   */
  public void advance(Duration duration) {
    if (duration.isNegative()) {
      throw new IllegalArgumentException("time cannot go back by " + duration.negated());
    }
    boolean unused = run(agenda.timeAfter(duration.toNanos()), () -> false);
  }

  /** The same, to an instant. */
  public void advanceTo(Instant instant) {
    advance(Duration.between(instant(), instant));
  }

  /**
   * Moves the time on until a condition holds, which is looked at after each thing that happens.
   *
   * @param atMost how far at most
   * @return whether it holds
   */
  public boolean advanceUntil(BooleanSupplier condition, Duration atMost) {
    return run(agenda.timeAfter(atMost.toNanos()), condition);
  }

  private boolean run(long until, BooleanSupplier enough) {
    if (isExecuting()) {
      throw new IllegalStateException(
          Thread.currentThread().getName()
              + " is moved by the time and cannot move it, nor wait for it in a task; have it done"
              + " later by after()");
    }
    stepping.lock();
    try {
      stepper = Thread.currentThread();
      scheduler.reclaim();
      while (!enough.getAsBoolean()) {
        ScheduledEvent next = agenda.next(until);
        if (next == null) {
          return enough.getAsBoolean();
        }
        next.action().run();
      }
      return true;
    } finally {
      stepping.unlock();
    }
  }

  /** Whether the calling thread is in the midst of a step. */
  private boolean isExecuting() {
    return stepping.isHeldByCurrentThread() || isStepped(Thread.currentThread());
  }

  private boolean isStepped(Thread thread) {
    return thread instanceof SteppedThread stepped && stepped.belongsTo(scheduler);
  }

  @Override
  public boolean isLockStep() {
    return true;
  }

  /** {@inheritDoc} It runs on the stepper's thread. What it throws ends the step. */
  @Override
  public ScheduledTask after(long nanos, Runnable task) {
    ScheduledEvent due = agenda.add(agenda.timeAfter(nanos), task, task);
    return () -> agenda.remove(due);
  }

  /**
   * Runs a task again and again, the first time after one period. Of tasks due at one instant those
   * that are repeated come in the order in which they were given here, whatever their periods.
   *
   * @param period longer than 0
   */
  public ScheduledTask every(Duration period, Runnable task) {
    if (period.isNegative() || period.isZero()) {
      throw new IllegalArgumentException("period " + period + " is not longer than 0");
    }
    return new RepeatingTask(agenda, period.toNanos(), task).start();
  }

  /** The simulated devices of this time. */
  @Override
  public SimLinkRegistry simLinks() {
    return links;
  }

  @Override
  public Condition newCondition(ReentrantLock lock) {
    return new SteppedCondition(this, scheduler, lock);
  }

  /** {@inheritDoc} It begins when the time is moved on after its start, also by nothing. */
  @Override
  public Thread newThread(String name, Runnable role) {
    return new SteppedThread(scheduler, name, role);
  }

  @Override
  public void await(Condition condition, long nanos) throws InterruptedException {
    if (!(condition instanceof SteppedCondition stepped && stepped.belongsTo(this))) {
      throw new IllegalArgumentException(
          "in lock-step a condition is made by Ticker.newCondition of the same time, but this one"
              + " is "
              + condition);
    }
    if (nanos > 0) {
      stepped.await(agenda.timeAfter(nanos));
    }
  }

  /** The time so long from now. */
  long timeAfter(long nanos) {
    return agenda.timeAfter(nanos);
  }

  /** One wait of the calling thread, which holds no lock. */
  void await(Wait wait, long until) throws InterruptedException {
    Thread caller = Thread.currentThread();
    if (caller instanceof SteppedThread stepped && stepped.belongsTo(scheduler)) {
      scheduler.await(stepped, wait, until);
    } else if (mayStep(caller)) {
      boolean unused = run(until, () -> scheduler.isOver(wait) || caller.isInterrupted());
    } else {
      scheduler.awaitOutside(wait, until);
    }
    if (Thread.interrupted()) {
      throw new InterruptedException();
    }
  }

  private boolean mayStep(Thread caller) {
    Thread last = stepper;
    return last == null || last == caller || !last.isAlive();
  }

  /** {@inheritDoc} It has turns meanwhile, without the time going on. */
  @Override
  public boolean join(Thread thread, Duration patience) throws InterruptedException {
    if (!isStepped(thread) || thread == Thread.currentThread()) {
      return Ticker.super.join(thread, patience);
    }
    long asked = System.nanoTime();
    long left = patience.toNanos();
    while (thread.isAlive() && left > 0) {
      if (isExecuting()) {
        end((SteppedThread) thread, left);
      } else if (stepping.tryLock(POLL_INTERVAL_MILLIS, TimeUnit.MILLISECONDS)) {
        try {
          end((SteppedThread) thread, left);
        } finally {
          stepping.unlock();
        }
      }
      left = patience.toNanos() - (System.nanoTime() - asked);
    }
    return !thread.isAlive();
  }

  private void end(SteppedThread thread, long patienceNanos) throws InterruptedException {
    if (scheduler.tryRun(thread, patienceNanos)) {
      thread.join(1); // its last steps are outside of its turn
    }
  }
}
