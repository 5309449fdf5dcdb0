package org.dfra.agent;

import java.io.Serializable;
import java.time.Duration;
import java.util.Objects;
import org.dfra.geometry.GeoPosition;

/**
 * What help is wanted.
 *
 * @param percept that the helper must be able to observe, e.g. {@code mine}
 * @param position where, frame WGS84
 * @param stayDuration for how long the helper is wanted there, above 0, at most {@link
 *     #MAX_DURATION}; one may have less time than that
 * @param searchTimeout for how long helpers are looked for, likewise; one that was chosen by then
 *     may still come
 */
public record HelpCall(
    String percept, GeoPosition position, Duration stayDuration, Duration searchTimeout)
    implements Serializable {

  /** Beyond it no span of a recruitment goes. */
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
