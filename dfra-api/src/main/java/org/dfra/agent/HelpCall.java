package org.dfra.agent;

import java.io.Serializable;
import java.time.Duration;
import java.util.Objects;
import org.dfra.geometry.GeoPosition;

/**
 * A request for help.
 *
 * @param percept the percept that the helper must be able to observe, e.g. {@code mine}
 * @param position where help is needed, frame WGS84
 * @param stayDuration how long the helper is needed there, above 0, at most {@link #MAX_DURATION};
 *     a helper may have less time than that
 * @param searchTimeout how long helpers are searched for, with the same limits; a helper chosen by
 *     then may still arrive later
 */
public record HelpCall(
    String percept, GeoPosition position, Duration stayDuration, Duration searchTimeout)
    implements Serializable {

  /** The upper limit of every duration in a recruitment. */
  public static final Duration MAX_DURATION = Duration.ofDays(30);

  public HelpCall {
    Objects.requireNonNull(position, "position");
    if (percept.isBlank()) {
      throw new IllegalArgumentException("a call without a percept asks for nothing; name one");
    }
    check("stayDuration", stayDuration);
    check("searchTimeout", searchTimeout);
  }

  private static void check(String what, Duration span) {
    if (span.isNegative() || span.isZero() || span.compareTo(MAX_DURATION) > 0) {
      double seconds = span.getSeconds() + span.getNano() / 1e9;
      throw new IllegalArgumentException(
          what
              + " "
              + seconds
              + " s is not above 0 and at most "
              + MAX_DURATION.toDays()
              + " days");
    }
  }
}
