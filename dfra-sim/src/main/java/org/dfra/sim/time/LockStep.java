package org.dfra.sim.time;

import com.google.errorprone.annotations.concurrent.GuardedBy;
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
import org.dfra.time.Scheduler.ScheduledTask;
import org.jspecify.annotations.Nullable;

/**
 * The clock of a bit-reproducible robot simulation: time advances only on request. During an
 * advance, all due events run one after the other, in an order that depends only on the program.
 *
 * <p>It is a module's clock and its scheduler ({@code new ModuleContext(robot, name, parameters,
 * time, state, leases, time)}); a driver's {@code Ticker.of(clock)} then uses this time too.
 * Threads that such a ticker created, the drivers' readers, run only during an advance, one at a
 * time: a reader is scheduled when bytes have arrived, its wait has ended or another thread signals
 * it, and the time advances when it waits again. Events due at the same instant run in the order of
 * entry; a repeated task keeps its position.
 *
 * <p>The thread that calls {@link #advance} is the stepper: tasks run on it. Other threads may call
 * the modules at any time, but their effects occur at an instant that is not reproducible, unless
 * they call between two steps. The stepper may call methods that wait (a module's diagnostics, for
 * example): the time then advances until they return. Other threads that wait, wait until the
 * stepper has advanced so far.
 *
 * <p>It reads no wall clock, except to detect a scheduled thread that never waits again: {@link
 * StuckThreadException}.
 */
public final class LockStep implements InstantSource, Scheduler, Ticker {

  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final long POLL_INTERVAL_MILLIS = 10;

  private final Instant begin;
  private final EventQueue queue = new EventQueue();
  private final LockStepScheduler scheduler;
  private final SimLinkRegistry links =
      new SimLinkRegistry(
          "the simulation has started none yet; org.dfra.sim.device.SimPort makes one");

  /** Held during an advance. Acquired before any other lock. */
  private final ReentrantLock stepping = new ReentrantLock();

  private volatile @Nullable Thread stepper;

  /** Creates a time that starts at {@code begin}. */
  public LockStep(Instant begin) {
    this(begin, PATIENCE);
  }

  /**
   * @param begin the first instant
   * @param patience real time that a scheduled thread may run before it counts as stuck
   */
  public LockStep(Instant begin, Duration patience) {
    this.begin = begin;
    this.scheduler = new LockStepScheduler(queue, patience);
  }

  @Override
  public Instant instant() {
    return begin.plusNanos(queue.now());
  }

  /** Nanoseconds since the first instant. */
  @Override
  public long nanos() {
    return queue.now();
  }

  /**
   * Advances the time and runs every event that is due by then.
   *
   * @throws StuckThreadException if a reader does not wait again
   * @throws IllegalStateException if a task or a reader calls this, or if events at one instant
   *     never end
   * @throws RuntimeException what a task throws; the time stays at that task's instant
   */
  public void advance(Duration duration) {
    if (duration.isNegative()) {
      throw new IllegalArgumentException("time cannot go back by " + duration.negated());
    }
    boolean unused = run(queue.timeAfter(duration.toNanos()), () -> false);
  }

  /** The same, to an instant. */
  public void advanceTo(Instant instant) {
    advance(Duration.between(instant(), instant));
  }

  /**
   * Advances the time until a condition holds, which is evaluated after each event.
   *
   * @param atMost maximum advance
   * @return whether it holds
   */
  public boolean advanceUntil(BooleanSupplier condition, Duration atMost) {
    return run(queue.timeAfter(atMost.toNanos()), condition);
  }

  private boolean run(long until, BooleanSupplier enough) {
    if (isExecuting()) {
      throw new IllegalStateException(
          Thread.currentThread().getName()
              + " runs in simulated time, so it cannot advance that time or wait for it in a task;"
              + " schedule the work with after()");
    }
    stepping.lock();
    try {
      stepper = Thread.currentThread();
      scheduler.reclaim();
      while (!enough.getAsBoolean()) {
        ScheduledEvent next = queue.next(until);
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

  /** Whether the calling thread is executing a step. */
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

  /** {@inheritDoc} It runs on the stepper's thread. An exception ends the step. */
  @Override
  public ScheduledTask after(long nanos, Runnable task) {
    ScheduledEvent due = queue.add(queue.timeAfter(nanos), task, task);
    return () -> queue.remove(due);
  }

  /**
   * Runs a task periodically, the first time after one period. Repeated tasks due at one instant
   * run in the order of their registration, regardless of their periods.
   *
   * @param period longer than 0
   */
  public ScheduledTask every(Duration period, Runnable task) {
    if (period.isNegative() || period.isZero()) {
      throw new IllegalArgumentException("period " + period + " is not longer than 0");
    }
    return new RepeatingTask(queue, period.toNanos(), task).start();
  }

  /** The simulated links of this time. */
  @Override
  public SimLinkRegistry simLinks() {
    return links;
  }

  @Override
  public Condition newCondition(ReentrantLock lock) {
    return new SteppedCondition(this, scheduler, lock);
  }

  /** {@inheritDoc} It starts at the next advance, even one of zero. */
  @Override
  public Thread newThread(String name, Runnable role) {
    return new SteppedThread(scheduler, name, role);
  }

  @Override
  public void await(Condition condition, long nanos) throws InterruptedException {
    if (!(condition instanceof SteppedCondition stepped && stepped.belongsTo(this))) {
      throw new IllegalArgumentException(
          "in lock-step a condition must come from Ticker.newCondition of the same time, but this one"
              + " is "
              + condition);
    }
    if (nanos > 0) {
      stepped.await(queue.timeAfter(nanos));
    }
  }

  /** The time after this delay. */
  long timeAfter(long nanos) {
    return queue.timeAfter(nanos);
  }

  /** Waits once in the calling thread, which holds no lock. */
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

  /** {@inheritDoc} It is scheduled meanwhile, without an advance of the time. */
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
      thread.join(1); // its last steps run outside its execution right
    }
  }

  /** A task that is scheduled again, a period later, before it runs. */
  private static final class RepeatingTask implements ScheduledTask {

    private final EventQueue queue;
    private final long period;
    private final Runnable task;

    @GuardedBy("this")
    private @Nullable ScheduledEvent next;

    @GuardedBy("this")
    private boolean cancelled;

    RepeatingTask(EventQueue queue, long period, Runnable task) {
      this.queue = queue;
      this.period = period;
      this.task = task;
    }

    synchronized RepeatingTask start() {
      next = queue.add(queue.timeAfter(period), task, this::run);
      return this;
    }

    private void run() {
      synchronized (this) {
        if (next == null || cancelled) {
          return;
        }
        next = queue.reschedule(next, queue.timeAfter(period));
      }
      task.run();
    }

    @Override
    public synchronized void cancel() {
      cancelled = true;
      if (next != null) {
        queue.remove(next);
      }
    }
  }

  /**
   * A scheduled thread did not wait again: it loops, or waits for something outside the simulated
   * time. The cause's stack trace is that thread's.
   */
  public static final class StuckThreadException extends IllegalStateException {

    private static final long serialVersionUID = 1;

    StuckThreadException(Thread thread, Duration patience) {
      super(
          thread.getName()
              + " did not wait again within "
              + patience.toMillis() / 1e3
              + " s of real time; the cause's stack shows where it is; let it wait there with its"
              + " Ticker and a condition of Ticker.newCondition",
          at(thread));
    }

    private static Throwable at(Thread thread) {
      Throwable there = new Throwable(thread.getName() + " is here");
      there.setStackTrace(thread.getStackTrace());
      return there;
    }
  }
}
