package org.dfra.time;

import java.io.Serializable;
import java.time.Duration;
import java.time.Instant;
import java.util.Locale;

/**
 * The offset of one clock relative to another, and its uncertainty. Two offsets relative to the
 * same third clock, such as satellite time, give the offset between the two:
 *
 * <pre>{@code
 * ClockOffset between = offsetOfB.relativeTo(offsetOfA);  // both relative to UTC
 * Instant onA = between.toOtherClock(reading.measured()); // a reading of B
 * }</pre>
 *
 * @param ahead the offset, + is ahead, − is behind
 * @param uncertainty maximum error of the offset, not negative
 */
public record ClockOffset(Duration ahead, Duration uncertainty) implements Serializable {

  public ClockOffset {
    if (uncertainty.isNegative()) {
      throw new IllegalArgumentException(
          "an offset is known within " + uncertainty + ", which is below 0 s");
    }
  }

  /**
   * The offset of this offset's clock from another's, where both are relative to one third clock.
   * The uncertainties add up.
   */
  public ClockOffset relativeTo(ClockOffset other) {
    return new ClockOffset(ahead.minus(other.ahead), uncertainty.plus(other.uncertainty));
  }

  /** A time of this offset's clock, as the other clock shows it. */
  public Instant toOtherClock(Instant time) {
    return time.minus(ahead);
  }

  /** The offset, seconds. */
  public double seconds() {
    return ahead.toNanos() / 1e9;
  }

  /** Maximum error of the offset, seconds. */
  public double uncertaintySeconds() {
    return uncertainty.toNanos() / 1e9;
  }

  /** Formatted as {@code +0.803 s ± 0.012 s}. */
  @Override
  public String toString() {
    return String.format(Locale.ROOT, "%+.3f s ± %.3f s", seconds(), uncertaintySeconds());
  }
}
