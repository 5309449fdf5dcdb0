package org.dfra.drivers.gps;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;

/**
 * Corrects the dates of receivers whose firmware has outlived its GPS week count. GPS counts its
 * weeks modulo 1024, so such a receiver reports a date that is exactly 1024 weeks (19.6 years), or
 * a multiple of it, too early; the time of day is right.
 *
 * <p>The rule: a date up to 512 weeks before the computer's clock is believed, and so is every
 * later one. An earlier date is moved later by as many times 1024 weeks as bring it within 512
 * weeks of the computer's clock. A computer without a clock battery may start in 1970: where its
 * clock is before {@link #RELEASED}, the date is moved to within 512 weeks of that day instead.
 *
 * <p>So the computer's clock may be wrong by years. A recording that is more than 512 weeks old is
 * moved as well when it is replayed: nothing tells it from a receiver with that fault.
 */
public final class WeekRollover {

  /** No computer runs this code before that. */
  static final Instant RELEASED = Instant.parse("2026-11-01T00:00:00Z");

  private static final Duration PERIOD = Duration.ofDays(7 * 1024);

  private final InstantSource clock;

  /**
   * @param clock the computer's clock
   */
  public WeekRollover(InstantSource clock) {
    this.clock = clock;
  }

  /** The time that a receiver means which reports this one. */
  public Instant correct(Instant reported) {
    Instant now = clock.instant();
    if (periods(reported, now) == 0) {
      return reported;
    }
    Instant reference = now.isBefore(RELEASED) ? RELEASED : now;
    return reported.plus(PERIOD.multipliedBy(periods(reported, reference)));
  }

  /** How many periods later is nearest to the reference; none where it is later already. */
  private static long periods(Instant reported, Instant reference) {
    long behind = Duration.between(reported, reference).toSeconds();
    long period = PERIOD.toSeconds();
    return Math.max(0, Math.floorDiv(behind + period / 2, period));
  }
}
