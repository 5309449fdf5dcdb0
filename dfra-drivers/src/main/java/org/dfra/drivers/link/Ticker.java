package org.dfra.drivers.link;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/**
 * A clock for code that waits: nanoseconds from an arbitrary origin, and methods to wait for them.
 * Tests step it; a simulated robot scales it or runs in lock-step with it.
 *
 * <p>Code that waits must create its conditions with {@link #newCondition} and its threads with
 * {@link #newThread}, and wait for their end with {@link #join}. A lock-step clock uses these to
 * know which threads are running; in real time they are plain conditions and threads.
 */
public interface Ticker {

  /** The time in nanoseconds; only differences are meaningful. */
  long nanos();

  /**
   * Waits until {@code condition} is signalled, at most {@code nanos} of this clock. May return
   * early, so the caller must check {@link #nanos} again.
   *
   * @param condition one of {@link #newCondition}, whose lock the caller holds
   * @param nanos maximum wait; no wait when not positive
   * @throws InterruptedException if the waiting thread is interrupted
   */
  void await(Condition condition, long nanos) throws InterruptedException;

  /** Makes a condition of {@code lock} for waits on this clock. */
  default Condition newCondition(ReentrantLock lock) {
    return lock.newCondition();
  }

  /**
   * Makes a daemon thread that waits on this clock; not started.
   *
   * @param name its name
   * @param role the task that it runs
   */
  default Thread newThread(String name, Runnable role) {
    Thread thread = new Thread(role, name);
    thread.setDaemon(true);
    return thread;
  }

  /**
   * Waits until a thread of {@link #newThread} has ended; the caller must have requested its end.
   *
   * @param patience maximum wait, in real time
   * @return whether it has ended
   * @throws InterruptedException if the waiting thread is interrupted
   */
  default boolean join(Thread thread, Duration patience) throws InterruptedException {
    thread.join(patience.toMillis());
    return !thread.isAlive();
  }

  /** The {@code sim:} links of the robot that uses this clock; empty in real time. */
  default SimLinkRegistry simLinks() {
    return SimLinkRegistry.NONE;
  }

  /** The computer's monotonic clock: it cannot be set, so it never jumps. */
  static Ticker system() {
    return SystemTicker.INSTANCE;
  }

  /**
   * The ticker for a module's clock. For the computer's own clock this is {@link #system}, so that
   * setting that clock (for example from GPS) neither shortens nor prolongs a wait. A clock that is
   * a ticker itself, such as that of a robot in lock-step, is returned unchanged. Any other clock
   * may be stopped or run at another speed, so it is polled every few milliseconds.
   */
  static Ticker of(InstantSource clock) {
    if (clock instanceof Ticker ticker) {
      return ticker;
    }
    return isSystemClock(clock) ? system() : new ClockTicker(clock);
  }

  /** Whether a clock is the computer's own, not that of a simulation. */
  static boolean isSystemClock(InstantSource clock) {
    return clock.equals(InstantSource.system())
        || (clock instanceof Clock c && c.equals(Clock.system(c.getZone())));
  }
}

/** The computer's monotonic clock. */
enum SystemTicker implements Ticker {
  INSTANCE;

  @Override
  public long nanos() {
    return System.nanoTime();
  }

  @Override
  @SuppressWarnings("WaitNotInLoop") // early return is part of the contract
  public void await(Condition condition, long nanos) throws InterruptedException {
    long unused = condition.awaitNanos(nanos);
  }
}

/** The time of a simulated clock, polled every few milliseconds. */
record ClockTicker(InstantSource clock) implements Ticker {

  private static final long LOOK_EVERY_NANOS = 5_000_000;

  @Override
  public long nanos() {
    Instant now = clock.instant();
    return now.getEpochSecond() * 1_000_000_000L + now.getNano();
  }

  @Override
  @SuppressWarnings("WaitNotInLoop") // early return is part of the contract
  public void await(Condition condition, long nanos) throws InterruptedException {
    long unused = condition.awaitNanos(Math.min(nanos, LOOK_EVERY_NANOS));
  }
}
