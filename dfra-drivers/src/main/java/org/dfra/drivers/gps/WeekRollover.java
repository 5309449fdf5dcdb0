package org.dfra.drivers.gps;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.function.UnaryOperator;
import org.dfra.drivers.link.LinkAddress;
import org.dfra.drivers.link.ReplayAddress;
import org.dfra.drivers.link.Ticker;

/**
 * Corrects the dates of receivers whose firmware has outlived its GPS week count. GPS counts its
 * weeks modulo 1024, so such a receiver reports a date that is exactly 1024 weeks (19.6 years), or
 * a multiple of it, too early; the time of day is right.
 *
 * <p>The rule depends on where the date comes from:
 *
 * <ul>
 *   <li>A <b>receiver</b> cannot report a date before {@link #RELEASED}, since this program did not
 *       exist then. Such a date is moved later by the smallest multiple of 1024 weeks that brings
 *       it to that day or a later one. Any other date is accepted. The computer's clock is not
 *       used, because it may be at 1970, years wrong, or behind the receiver.
 *   <li>A <b>recording</b> ({@code replay:}) may be from any year. Its dates are left as they were
 *       recorded.
 *   <li>In a <b>simulation</b>, which may be in any year too, the simulated clock is right. A date
 *       up to 512 weeks before it, or later than it, is accepted; an earlier one is moved to within
 *       512 weeks of it.
 * </ul>
 *
 * <p>Only dates that a receiver has reported are corrected, never those of the computer's clock
 * that are used while the receiver's date is unknown.
 */
public final class WeekRollover {

  /** This code did not exist before that date. Must be moved later by a release before 2046. */
  static final Instant RELEASED = Instant.parse("2026-11-01T00:00:00Z");

  private static final Duration PERIOD = Duration.ofDays(7 * 1024);

  private final UnaryOperator<Instant> rule;

  private WeekRollover(UnaryOperator<Instant> rule) {
    this.rule = rule;
  }

  /**
   * The rule for the dates that come over a link.
   *
   * @param clock the clock of the module that reads the receiver
   * @param link where the receiver is
   */
  public static WeekRollover of(InstantSource clock, LinkAddress link) {
    if (link instanceof ReplayAddress) {
      return new WeekRollover(recorded -> recorded);
    }
    return Ticker.isSystemClock(clock)
        ? new WeekRollover(WeekRollover::sinceTheRelease)
        : new WeekRollover(reported -> near(clock.instant(), reported));
  }

  /** The correct time for a reported time. */
  public Instant correct(Instant reported) {
    return rule.apply(reported);
  }

  private static Instant sinceTheRelease(Instant reported) {
    return later(reported, RELEASED, PERIOD.toSeconds() - 1); // rounds up
  }

  private static Instant near(Instant now, Instant reported) {
    return later(reported, now, PERIOD.toSeconds() / 2); // rounds to the nearest
  }

  /**
   * Moves a time later by whole periods, to that time.
   *
   * @param rounding added to the difference in seconds before the division
   */
  private static Instant later(Instant reported, Instant to, long rounding) {
    long behind = Duration.between(reported, to).toSeconds();
    long periods = Math.floorDiv(behind + rounding, PERIOD.toSeconds());
    return reported.plus(PERIOD.multipliedBy(Math.max(0, periods)));
  }
}
