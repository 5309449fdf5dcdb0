package org.dfra.behaviors.perceptual.pose;

import java.time.Duration;
import java.util.Arrays;
import java.util.Optional;
import org.dfra.time.ClockOffset;

/**
 * Estimates the offset of the robot's clock ahead of UTC. A fix is received a latency after its
 * epoch, so its reception time minus its epoch is an upper bound of the offset. The estimate is the
 * minimum of the last {@value #FIX_COUNT} fixes of all receivers, without those more than {@value
 * #SPREAD_SECONDS} s below the median, since a receiver without an almanac may report a wrong UTC.
 *
 * <p>The estimate is too large by the minimum latency, about 0.16 s for an M12+ at 9600 baud. This
 * is the same for robots of equal design and cancels where their poses are compared.
 *
 * <p>Its further uncertainty is the sum of three: the excess of the minimum of a few latencies over
 * that of many, if they are distributed exponentially ({@value #SURE} times its mean, which one in
 * 150 exceeds); the clock's drift, at most {@value #DRIFT} of the time since the oldest of the
 * fixes was received; and 5 ms, by which the minimum latencies of receivers of one type may differ.
 */
final class UtcOffsetEstimator {

  /** Fixes stored: half a minute of two receivers at 1 Hz. */
  static final int FIX_COUNT = 64;

  static final int SPREAD_SECONDS = 2;

  private static final long SPREAD = SPREAD_SECONDS * EpochNanos.SECOND;

  private static final double SURE = 5;

  /** Seconds per second; a poor crystal in the heat. */
  private static final double DRIFT = 1e-4;

  /** Nanoseconds. */
  private static final double UNLIKE = 5e6;

  /** Assumed mean latency of a fix, nanoseconds, as one prior sample. */
  private static final double USUALLY_LATE = 1e8;

  private final long[] kept = new long[FIX_COUNT];
  private final long[] arrivals = new long[FIX_COUNT];
  private int count;
  private long least;
  private long oldest; // reception times of stored fixes
  private double excess; // nanoseconds, excess of this minimum over that of many

  /** Adds a fix with its epoch, UTC, and its reception time by the robot's clock. */
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

  /** Resets it: the robot's clock was set. */
  void clear() {
    count = 0;
  }

  /** The estimate, nanoseconds, + is ahead of UTC; 0 before the first fix. */
  long offsetNanos() {
    return count == 0 ? 0 : least;
  }

  /**
   * The estimate, and its uncertainty besides the minimum latency; empty before the first fix.
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
