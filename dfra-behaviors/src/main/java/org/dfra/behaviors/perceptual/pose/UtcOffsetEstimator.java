package org.dfra.behaviors.perceptual.pose;

import java.time.Duration;
import java.util.Arrays;
import java.util.Optional;
import org.dfra.time.ClockOffset;

/**
 * How far the robot's clock is ahead of UTC. A fix of a moment is heard a latency later, so each
 * fix says: ahead by its arrival less its moment, or by less. The least of the last {@value
 * #FIX_COUNT} is taken, all receivers together, without those that are more than {@value
 * #SPREAD_SECONDS} s below the median, since a receiver without the almanac may be wrong about UTC.
 *
 * <p>The estimate is too great by the least latency, about 0.16 s for an M12+ at 9600 baud. It is
 * the same for robots that are built alike and drops out where their poses are compared.
 *
 * <p>What it may be off by besides is the sum of three: what the least of so few latencies exceeds
 * the least of many by, where they are spread exponentially ({@value #SURE} times its mean, which
 * one in 150 exceeds); what a clock drifts, at {@value #DRIFT} of the time at the most, since the
 * oldest of the fixes was heard; and 5 ms, by which the least latencies of receivers of a kind may
 * differ.
 */
final class UtcOffsetEstimator {

  /** Fixes remembered: half a minute of two receivers at 1 Hz. */
  static final int FIX_COUNT = 64;

  static final int SPREAD_SECONDS = 2;

  private static final long SPREAD = SPREAD_SECONDS * EpochNanos.SECOND;

  private static final double SURE = 5;

  /** Seconds in a second; a poor crystal in the heat. */
  private static final double DRIFT = 1e-4;

  /** Nanoseconds. */
  private static final double UNLIKE = 5e6;

  /** How late a fix is taken to be on average, nanoseconds, as if one had told so beforehand. */
  private static final double USUALLY_LATE = 1e8;

  private final long[] kept = new long[FIX_COUNT];
  private final long[] arrivals = new long[FIX_COUNT];
  private int count;
  private long least;
  private long oldest; // arrival of those that are kept
  private double excess; // nanoseconds that the least may be above the least of many

  /** Takes a fix of a moment, UTC, that was heard at a time of the robot's clock. */
  void addFix(long utc, long received) {
    kept[count % FIX_COUNT] = received - utc;
    arrivals[count % FIX_COUNT] = received;
    count = count + 1 == 2 * FIX_COUNT ? FIX_COUNT : count + 1; // stays above KEPT once it is full
    int number = Math.min(count, FIX_COUNT);
    long[] sorted = Arrays.copyOf(kept, number);
    Arrays.sort(sorted);
    long median = sorted[number / 2];
    int i = 0;
    while (sorted[i] < median - SPREAD) {
      i++;
    }
    least = sorted[i];
    double late = ((median - least) / Math.log(2) * number + USUALLY_LATE) / number; // mean
    excess = SURE * late / number;
    oldest = Arrays.stream(arrivals, 0, number).min().orElse(received);
  }

  /** Forgets all: the robot's clock was set. */
  void clear() {
    count = 0;
  }

  /** The estimate, nanoseconds, + is ahead of UTC; 0 before the first fix. */
  long offsetNanos() {
    return count == 0 ? 0 : least;
  }

  /**
   * The estimate, and what it may be off by besides the least latency; empty before the first fix.
   *
   * @param now by the robot's clock
   */
  Optional<ClockOffset> estimate(long now) {
    if (count == 0) {
      return Optional.empty();
    }
    double within = excess + DRIFT * Math.max(0, now - oldest) + UNLIKE;
    return Optional.of(
        new ClockOffset(Duration.ofNanos(least), Duration.ofNanos(Math.round(within))));
  }
}
