package org.dfra.cli.team;

import java.time.Duration;
import java.time.Instant;

/** When a lookup service last listed something, as text. */
public final class LastSeen {

  private static final Duration TWO_MINUTES = Duration.ofMinutes(2);
  private static final Duration TWO_HOURS = Duration.ofHours(2);

  private LastSeen() {}

  /**
   * {@code now}, or {@code stale, 12 s ago}.
   *
   * @param stale whether no responding lookup service lists it
   * @param confirmed when one last did
   */
  public static String of(boolean stale, Instant confirmed) {
    return stale
        ? "stale, " + formatSpan(Duration.between(confirmed, Instant.now())) + " ago"
        : "now";
  }

  /** {@code 12 s}, {@code 5 min} or {@code 3 h}; {@code 0 s} for negative durations. */
  public static String formatSpan(Duration span) {
    if (span.compareTo(TWO_MINUTES) < 0) {
      return Math.max(0, span.toSeconds()) + " s";
    }
    return span.compareTo(TWO_HOURS) < 0 ? span.toMinutes() + " min" : span.toHours() + " h";
  }
}
