package org.dfra.drivers.link;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/**
 * Time for logic that waits: a count of nanoseconds from an arbitrary origin, and a way to wait for
 * it. Tests step it; a simulated robot scales it or runs in lock-step with it.
 *
 * <p>Whoever waits takes its conditions from {@link #newCondition} and its threads from {@link
 * #newThread}, and waits for their end by {@link #join}. In lock-step that is how the time knows
 * who is at work; in real time these are what they seem.
 */
public interface Ticker {

  /** The time in nanoseconds; only differences mean something. */
  long nanos();

  /**
   * Waits until {@code condition} is signalled, at the longest for {@code nanos} of this time. May
   * return early, so the caller looks at {@link #nanos} again.
   *
   * @param condition one of {@link #newCondition}, whose lock the caller holds
   * @param nanos longest wait; none when not positive
   * @throws InterruptedException if the waiting thread is interrupted
   */
  void await(Condition condition, long nanos) throws InterruptedException;

  /** A condition of {@code lock} to wait for by this time. */
  default Condition newCondition(ReentrantLock lock) {
    return lock.newCondition();
  }

  /**
   * A daemon thread that waits by this time; not started.
   *
   * @param name its role
   * @param role what it does until it ends
   */
  default Thread newThread(String name, Runnable role) {
    Thread thread = new Thread(role, name);
    thread.setDaemon(true);
    return thread;
  }

  /**
   * Waits until a thread of {@link #newThread} has ended, which it has been told to do.
   *
   * @param patience longest wait, in real time
   * @return whether it has ended
   * @throws InterruptedException if the waiting thread is interrupted
   */
  default boolean join(Thread thread, Duration patience) throws InterruptedException {
    thread.join(patience.toMillis());
    return !thread.isAlive();
  }

  /** The {@code sim:} links of the robot that lives by this time; none where that is real. */
  default SimLinkRegistry simLinks() {
    return SimLinkRegistry.NONE;
  }

  /** The computer's monotonic time: nobody sets it, so it never jumps. */
  static Ticker system() {
    return SystemTicker.INSTANCE;
  }

  /**
   * The time a module's clock goes by. For the computer's own clock this is {@link #system}, so
   * that setting the clock (by this very GPS, say) ends no wait early and prolongs none. A clock
   * that is a ticker itself, as that of a robot in lock-step, is taken as it is. Any other clock
   * may be stopped or run at another speed, so it is looked at every few milliseconds.
   */
  static Ticker of(InstantSource clock) {
    if (clock instanceof Ticker ticker) {
      return ticker;
    }
    return isSystemClock(clock) ? system() : new ClockTicker(clock);
  }

  /** Whether a clock is the computer's own, and not that of a simulation. */
  static boolean isSystemClock(InstantSource clock) {
    return clock.equals(InstantSource.system())
        || (clock instanceof Clock c && c.equals(Clock.system(c.getZone())));
  }
}

/** The computer's monotonic time. */
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

/** The time of a simulated clock, by looking at it every few milliseconds. */
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
