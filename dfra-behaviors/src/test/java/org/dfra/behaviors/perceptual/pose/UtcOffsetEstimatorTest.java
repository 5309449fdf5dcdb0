package org.dfra.behaviors.perceptual.pose;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.dfra.time.ClockOffset;
import org.junit.jupiter.api.Test;

/** How well a clock's offset is estimated, and that its uncertainty is right. */
class UtcOffsetEstimatorTest {

  private static final long LEAST = 160_000_000; // nanoseconds
  private static final double MEAN = 3e7; // nanoseconds, of what latencies are above that

  /** Fixes twice a second; the clock is ahead by so many nanoseconds at the beginning. */
  private static ClockOffset after(int fixes, long ahead, double drift, SplittableRandom random) {
    UtcOffsetEstimator offset = new UtcOffsetEstimator();
    long now = 0;
    for (int i = 0; i < fixes; i++) {
      long utc = i * 500_000_000L;
      long received = utc + LEAST + (long) (-MEAN * Math.log(1 - random.nextDouble()));
      now = received + ahead + (long) (drift * received);
      offset.addFix(utc, now);
    }
    return offset.estimate(now).orElseThrow();
  }

  @Test
  void theErrorIsWithinTheReportedUncertainty() {
    int wrong = 0;
    int all = 0;
    for (long seed = 0; seed < 200; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      for (int fixes : new int[] {2, 5, 20, 64, 300}) {
        long ahead = random.nextLong(-2_000_000_000L, 2_000_000_000L);
        double drift = random.nextDouble(-1e-4, 1e-4);
        ClockOffset reported = after(fixes, ahead, drift, random);
        double truly = ahead / 1e9 + drift * fixes * 0.5 + LEAST / 1e9;
        all++;
        if (Math.abs(reported.seconds() - truly) > reported.uncertaintySeconds()) {
          wrong++;
        }
      }
    }
    // With few latencies the reported uncertainty allows one in 150; drift and the rest add some.
    assertThat(wrong)
        .as("of %d, more are off than the reported uncertainty", all)
        .isLessThanOrEqualTo(all / 100);
  }

  @Test
  void itIsKnownBetterWithMoreFixesAndWorseWhenTheyStop() {
    SplittableRandom random = new SplittableRandom(1);
    double one = after(1, 0, 0, random).uncertaintySeconds();
    double some = after(8, 0, 0, random).uncertaintySeconds();
    double many = after(64, 0, 0, random).uncertaintySeconds();
    assertThat(many).isLessThan(some).isLessThan(0.02);
    assertThat(some).isLessThan(one);
    UtcOffsetEstimator offset = new UtcOffsetEstimator();
    offset.addFix(0, LEAST);
    double now = offset.estimate(LEAST).orElseThrow().uncertaintySeconds();
    double later = offset.estimate(LEAST + 600_000_000_000L).orElseThrow().uncertaintySeconds();
    assertThat(later - now).as("a ten-thousandth of ten minutes").isBetween(0.059, 0.061);
  }

  @Test
  void withoutAFixNothingIsKnown() {
    UtcOffsetEstimator offset = new UtcOffsetEstimator();
    assertThat(offset.estimate(0)).isEmpty();
    offset.addFix(0, LEAST);
    offset.clear();
    assertThat(offset.estimate(0)).isEmpty();
  }
}
