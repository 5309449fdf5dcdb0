package org.dfra.app.doctor;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Optional;
import java.util.concurrent.Callable;

/**
 * The offset between another clock and this computer's, measured as by NTP (RFC 5905, section 8):
 * of several requests the one with the shortest round trip counts, and its time stamp is taken to
 * be from the middle of the round trip.
 *
 * @param offset positive if the other clock is ahead
 * @param uncertainty half the round trip: the maximum error of the offset
 */
record NtpClockOffset(Duration offset, Duration uncertainty) {

  /** Lower bound of the absolute offset. */
  Duration atLeast() {
    Duration least = offset.abs().minus(uncertainty);
    return least.isNegative() ? Duration.ZERO : least;
  }

  /**
   * Queries another clock.
   *
   * @param times number of requests, at least 1
   * @param other returns the time there
   * @param here this computer's clock
   * @throws Exception thrown by the other clock
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
