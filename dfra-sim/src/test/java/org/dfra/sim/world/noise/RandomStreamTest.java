package org.dfra.sim.world.noise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.dfra.sim.world.Statistics;
import org.junit.jupiter.api.Test;

class RandomStreamTest {

  @Test
  void areThoseOfSplittableRandomAtAnyPlace() {
    for (long seed : new long[] {0, 1, -1, Long.MIN_VALUE, 0x123456789ABCDEFL}) {
      SplittableRandom oracle = new SplittableRandom(seed);
      RandomStream draws = new RandomStream(seed);
      for (int i = 0; i < 100; i++) {
        assertThat(draws.bits(i)).as("seed %d, draw %d", seed, i).isEqualTo(oracle.nextLong());
      }
    }
  }

  @Test
  void namesHaveStreamsOfTheirOwn() {
    RandomStream draws = new RandomStream(1);
    assertThat(draws.substream("laser"))
        .isEqualTo(draws.substream("laser"))
        .isNotEqualTo(draws.substream("laser_2"));
    assertThat(draws.substream("laser")).isNotEqualTo(new RandomStream(2).substream("laser"));
    assertThat(draws.substream("a").substream("b"))
        .isNotEqualTo(draws.substream("b").substream("a"));
  }

  /** The quantiles of published tables, to all their digits. */
  @Test
  void normalQuantilesAreThoseOfTheTables() {
    assertThat(Normal.quantile(0.5)).isZero();
    assertThat(Normal.quantile(0.75)).isCloseTo(0.674489750196082, within(1e-14));
    assertThat(Normal.quantile(0.9)).isCloseTo(1.281551565544600, within(1e-14));
    assertThat(Normal.quantile(0.975)).isCloseTo(1.959963984540054, within(1e-14));
    assertThat(Normal.quantile(0.005)).isCloseTo(-2.575829303548901, within(1e-14));
    assertThat(Normal.quantile(1e-6)).isCloseTo(-4.753424308822899, within(1e-13));
    assertThat(Normal.quantile(1e-15)).isCloseTo(-7.941345326170997, within(1e-13));
  }

  /**
   * Of 100 000 samples the mean is known to 1/316, σ to 1/447, correlations to 1/316; four times.
   */
  @Test
  void gaussianDrawsAreNormalAndUnrelated() {
    RandomStream draws = new RandomStream(7).substream("white");
    double[] samples = new double[100_000];
    int beyond = 0;
    for (int i = 0; i < samples.length; i++) {
      samples[i] = draws.gaussian(i);
      beyond += Math.abs(samples[i]) > 2 ? 1 : 0;
    }
    assertThat(Statistics.mean(samples)).isCloseTo(0, within(0.0127));
    assertThat(Statistics.sigma(samples)).isCloseTo(1, within(0.009));
    assertThat(Statistics.correlation(samples, 1)).isCloseTo(0, within(0.0127));
    assertThat(beyond / 100_000.0).isCloseTo(0.0455, within(0.0027)); // 4 √(p (1 − p) / n)
  }
}
