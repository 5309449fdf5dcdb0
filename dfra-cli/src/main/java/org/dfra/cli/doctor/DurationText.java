package org.dfra.cli.doctor;

import java.time.Duration;
import java.util.Locale;

/** Short durations as text. */
final class DurationText {

  private DurationText() {}

  /** {@code 0.3 ms}, {@code 12 ms}; from two seconds on {@code 2.5 s}. */
  static String of(Duration span) {
    double millis = span.toNanos() / 1e6;
    double size = Math.abs(millis);
    if (size >= 2000) {
      return String.format(Locale.ROOT, "%.1f s", millis / 1000);
    }
    return String.format(Locale.ROOT, size < 10 ? "%.1f ms" : "%.0f ms", millis);
  }
}
