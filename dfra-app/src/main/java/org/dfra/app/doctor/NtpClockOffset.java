package org.dfra.app.doctor;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Optional;
import java.util.concurrent.Callable;

/**
 * How far another clock is off this computer's, measured as NTP does (RFC 5905, section 8): of
 * several questions the one with the quickest answer counts, and the answer is taken to be of the
 * middle of its round trip.
 *
 * @param offset positive where the other clock is ahead
 * @param uncertainty half the round trip: the offset is wrong by so much at most
 */
record NtpClockOffset(Duration offset, Duration uncertainty) {

  /** By how much the clocks differ at the least. */
  Duration atLeast() {
    Duration least = offset.abs().minus(uncertainty);
    return least.isNegative() ? Duration.ZERO : least;
  }

  /**
   * Asks another clock.
   *
   * @param times how often, at least once
   * @param other tells the time there
   * @param here this computer's clock
   * @throws Exception what the other clock throws
   */
  static NtpClockOffset measure(int times, Callable<Instant> other, InstantSource here)
      throws Exception {
    Optional<NtpClockOffset> best = Optional.empty();
    for (int i = 0; i < times; i++) {
      Instant asked = here.instant();
      Instant reported = other.call();
      Duration half = Duration.between(asked, here.instant()).dividedBy(2);
      NtpClockOffset offset =
          new NtpClockOffset(Duration.between(asked.plus(half), reported), half);
      if (best.isEmpty() || half.compareTo(best.get().uncertainty()) < 0) {
        best = Optional.of(offset);
      }
    }
    return best.orElseThrow(() -> new IllegalArgumentException("asked " + times + " times"));
  }
}
