package org.dfra.drivers.gps.nmea;

import java.time.Duration;
import java.time.Instant;
import java.time.LocalDate;
import java.time.LocalTime;
import java.time.ZoneOffset;
import org.jspecify.annotations.Nullable;

/**
 * Finds the date of a time of day, also across midnight and where the sentence with the date is
 * sent less often than the others. Confined to one thread.
 */
final class NmeaDateResolver {

  private static final Duration HALF_A_DAY = Duration.ofHours(12);
  private static final Duration DAY = Duration.ofDays(1);

  /** The last time with a known date; null before the first. */
  private @Nullable Instant last;

  void forget() {
    last = null;
  }

  /** The receiver reports this date and time, UTC; without either it reports nothing. */
  void update(@Nullable LocalDate date, @Nullable LocalTime time) {
    if (date != null && time != null) {
      last = time.atDate(date).toInstant(ZoneOffset.UTC);
    }
  }

  /** Whether the receiver has reported a date. */
  boolean isKnown() {
    return last != null;
  }

  /**
   * The instant with this time of day that is nearest to the last known one; before the first,
   * nearest to the host's time.
   */
  Instant resolve(LocalTime time, Instant host) {
    Instant near = last == null ? host : last;
    Instant there =
        time.atDate(LocalDate.ofInstant(near, ZoneOffset.UTC)).toInstant(ZoneOffset.UTC);
    Duration ahead = Duration.between(near, there);
    if (ahead.compareTo(HALF_A_DAY) > 0) {
      there = there.minus(DAY);
    } else if (ahead.negated().compareTo(HALF_A_DAY) > 0) {
      there = there.plus(DAY);
    }
    last = last == null ? null : there;
    return there;
  }
}
