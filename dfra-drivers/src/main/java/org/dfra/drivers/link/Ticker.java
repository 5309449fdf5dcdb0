package org.dfra.drivers.link;

import java.time.Clock;
import java.time.Instant;
import java.time.InstantSource;
import java.util.concurrent.locks.Condition;

/**
 * Time for logic that waits: a count of nanoseconds from an arbitrary origin, and a way to wait for
 * it. Tests step it; a simulated robot scales it.
 */
public interface Ticker {

  /** The time in nanoseconds; only differences mean something. */
  long nanos();

  /**
   * Waits until {@code condition} is signalled, at the longest for {@code nanos} of this time. May
   * return early, so the caller looks at {@link #nanos} again.
   *
   * @param condition a condition whose lock the caller holds
   * @param nanos longest wait; none when not positive
   * @throws InterruptedException if the waiting thread is interrupted
   */
  void await(Condition condition, long nanos) throws InterruptedException;

  /** The computer's monotonic time: nobody sets it, so it never jumps. */
  static Ticker system() {
    return SystemTicker.INSTANCE;
  }

  /**
   * The time a module's clock goes by. For the computer's own clock this is {@link #system}, so
   * that setting the clock (by this very GPS, say) ends no wait early and prolongs none. Any other
   * clock may be stopped or run at another speed, so it is looked at every few milliseconds.
   */
  static Ticker of(InstantSource clock) {
    boolean real =
        clock.equals(InstantSource.system())
            || (clock instanceof Clock c && c.equals(Clock.system(c.getZone())));
    return real ? system() : new ClockTicker(clock);
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
