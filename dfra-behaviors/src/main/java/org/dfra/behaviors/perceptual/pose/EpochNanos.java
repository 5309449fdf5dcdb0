package org.dfra.behaviors.perceptual.pose;

import java.time.Duration;
import java.time.Instant;

/** Instants as nanoseconds since 1970: their differences are exact and never overflow. */
final class EpochNanos {

  static final long SECOND = 1_000_000_000L;

  /** Supported seconds before and after 1970: the years 1844 to 2096. */
  private static final long FARTHEST = 4_000_000_000L;

  private EpochNanos() {}

  /** Whether the time is plausible for a clock. */
  static boolean isPlausible(Instant time) {
    return Math.abs(time.getEpochSecond()) < FARTHEST;
  }

  /** The instant in nanoseconds, clamped to the supported range. */
  static long of(Instant time) {
    long seconds = Math.max(-FARTHEST, Math.min(FARTHEST, time.getEpochSecond()));
    return seconds * SECOND + time.getNano();
  }

  static Instant instant(long time) {
    return Instant.ofEpochSecond(Math.floorDiv(time, SECOND), Math.floorMod(time, SECOND));
  }

  /** Seconds from one to the other; less than 0 if that is earlier. */
  static double seconds(long from, long to) {
    return (to - from) * 1e-9;
  }

  /** Converts to seconds. */
  static long of(double seconds) {
    return Math.round(seconds * SECOND);
  }

  static double seconds(Duration span) {
    return span.toNanos() * 1e-9;
  }
}
