package org.dfra.time;

import java.io.Serializable;
import java.time.Duration;
import java.time.Instant;
import java.util.Locale;

/**
 * How far one clock is ahead of another, and how well that is known. Two that are known against the
 * same third one, such as the time of satellites, are known against each other:
 *
 * <pre>{@code
 * ClockOffset between = offsetOfB.against(offsetOfA);   // both against UTC
 * Instant onA = between.onTheOther(reading.measured()); // a reading of B
 * }</pre>
 *
 * @param ahead by how much, + is ahead, − is behind
 * @param uncertainty what that may be off by at the most, not negative
 */
public record ClockOffset(Duration ahead, Duration uncertainty) implements Serializable {

  public ClockOffset {
    if (uncertainty.isNegative()) {
      throw new IllegalArgumentException(
          "an offset is known within " + uncertainty + ", which is below 0 s");
    }
  }

  /**
   * How far this offset's clock is ahead of another's, where both offsets are against one third
   * clock. What they may be off by adds up.
   */
  public ClockOffset relativeTo(ClockOffset other) {
    return new ClockOffset(ahead.minus(other.ahead), uncertainty.plus(other.uncertainty));
  }

  /** A time of this offset's clock, as the other clock shows it. */
  public Instant toOtherClock(Instant time) {
    return time.minus(ahead);
  }

  /** By how much it is ahead, seconds. */
  public double seconds() {
    return ahead.toNanos() / 1e9;
  }

  /** What that may be off by at the most, seconds. */
  public double uncertaintySeconds() {
    return uncertainty.toNanos() / 1e9;
  }

  /** In words: {@code +0.803 s ± 0.012 s}. */
  @Override
  public String toString() {
    return String.format(Locale.ROOT, "%+.3f s ± %.3f s", seconds(), uncertaintySeconds());
  }
}
