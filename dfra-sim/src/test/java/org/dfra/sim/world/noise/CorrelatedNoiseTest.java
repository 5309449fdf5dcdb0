package org.dfra.sim.world.noise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.dfra.sim.world.Statistics;
import org.junit.jupiter.api.Test;

class CorrelatedNoiseTest {

  /**
   * 2 000 000 s of a correlation time of 200 s are 5000 independent values: the mean is known to
   * 1.4 % of σ, σ to 1 %, a correlation to about 0.02; four times that is allowed.
   */
  @Test
  void gaussMarkovKeepsItsSigmaAndItsTime() {
    CorrelatedNoise drift = CorrelatedNoise.gaussMarkov(new RandomStream(3), 1.5, 200, 1);
    double[] samples = new double[2_000_000];
    for (int i = 0; i < samples.length; i++) {
      samples[i] = drift.at(i);
    }
    assertThat(Statistics.mean(samples)).isCloseTo(0, within(4 * 0.014 * 1.5));
    assertThat(Statistics.sigma(samples)).isCloseTo(1.5, within(0.04 * 1.5));
    assertThat(Statistics.correlation(samples, 100)).isCloseTo(Math.exp(-0.5), within(0.06));
    assertThat(Statistics.correlation(samples, 200)).isCloseTo(Math.exp(-1), within(0.08));
    assertThat(Statistics.correlation(samples, 600)).isCloseTo(Math.exp(-3), within(0.08));
  }

  /** It is so spread from the first step on; of 2000 streams σ is known to 1.6 %. */
  @Test
  void gaussMarkovBeginsAsSpreadAsItGoesOn() {
    double[] first = new double[2000];
    double[] later = new double[2000];
    for (int i = 0; i < first.length; i++) {
      CorrelatedNoise drift =
          CorrelatedNoise.gaussMarkov(new RandomStream(5).substream(i), 2, 10, 0.01);
      first[i] = drift.at(0);
      later[i] = drift.at(300);
    }
    assertThat(Statistics.sigma(first)).isCloseTo(2, within(0.13));
    assertThat(Statistics.sigma(later)).isCloseTo(2, within(0.13));
  }

  /** After t a walk of 0.1 per root second has spread to 0.1 √t; of 2000 that is known to 1.6 %. */
  @Test
  void aWalkSpreadsWithTheRootOfTime() {
    double[] at4 = new double[2000];
    double[] at100 = new double[2000];
    for (int i = 0; i < at4.length; i++) {
      CorrelatedNoise walk = CorrelatedNoise.walk(new RandomStream(6).substream(i), 1, 0.1, 0.01);
      assertThat(walk.at(0)).isEqualTo(1);
      at4[i] = walk.at(400);
      at100[i] = walk.at(10_000);
    }
    assertThat(Statistics.mean(at100)).isCloseTo(1, within(4 / Math.sqrt(2000)));
    assertThat(Statistics.sigma(at4)).isCloseTo(0.2, within(0.2 * 0.064));
    assertThat(Statistics.sigma(at100)).isCloseTo(1, within(0.064));
  }

  @Test
  void theValueOfAStepDoesNotDependOnWhoAsksWhen() {
    CorrelatedNoise often = CorrelatedNoise.gaussMarkov(new RandomStream(1), 1, 5, 0.01);
    for (int i = 0; i < 1000; i++) {
      double unused = often.at(i);
    }
    CorrelatedNoise once = CorrelatedNoise.gaussMarkov(new RandomStream(1), 1, 5, 0.01);
    assertThat(once.at(999)).isEqualTo(often.at(999));
    assertThat(once.at(900)).as("asked late").isEqualTo(often.at(900));
    assertThat(once.at(0))
        .as("the oldest known")
        .isEqualTo(often.at(999 - CorrelatedNoise.REMEMBERED + 1));
  }

  /**
   * Ten an hour of 20 s on average in 1000 hours: 10 000 spells, so their number is known to 1 %
   * and the time they take to 1.4 %; four times that is allowed.
   */
  @Test
  void spellsComeAsOftenAndLastAsLongAsTheyShould() {
    OutageProcess spells = new OutageProcess(new RandomStream(9), 10, 20);
    int on = 0;
    int begun = 0;
    boolean was = false;
    int seconds = 3_600_000;
    for (int i = 0; i < seconds; i++) {
      boolean is = spells.isActive(i);
      on += is ? 1 : 0;
      begun += is && !was ? 1 : 0;
      was = is;
    }
    assertThat(on / (double) seconds).isCloseTo(10 * 20 / 3600.0, within(0.056 * 0.0556));
    // A spell that falls between two looks is not seen: of those 1 s apart at most 1/20.
    assertThat(begun / 1000.0).isBetween(9.1, 10.4);
    assertThat(new OutageProcess(new RandomStream(9), 0, 20).isActive(1e9)).isFalse();
  }
}
