package org.dfra.experiments.recruit.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class EstimateTest {

  /** 2.776445 is the quantile of Student's distribution at 97.5 % with four degrees of freedom. */
  @Test
  void aMeanIsAsSureAsStudentSays() {
    Estimate mean = Estimate.mean(new double[] {1, 2, Double.NaN, 3, 4, 5});
    double half = 2.776445 * Math.sqrt(2.5 / 5);
    assertThat(mean.value()).isEqualTo(3);
    assertThat(mean.low()).isCloseTo(3 - half, within(1e-6));
    assertThat(mean.high()).isCloseTo(3 + half, within(1e-6));
  }

  @Test
  void whatIsAlwaysTheSameIsSure() {
    assertThat(Estimate.mean(new double[] {7, 7, 7})).isEqualTo(new Estimate(7, 7, 7));
  }

  @Test
  void nothingIsKnownOfTheSpreadOfOne() {
    Estimate mean = Estimate.mean(new double[] {7});
    assertThat(mean.value()).isEqualTo(7);
    assertThat(mean.low()).isNaN();
    assertThat(mean.high()).isNaN();
  }

  @Test
  void pairsAreComparedOneByOne() {
    Estimate less = Estimate.paired(new double[] {1, 2, 3}, new double[] {2, 4, 6});
    assertThat(less.value()).isEqualTo(-2);
    assertThat(less.low()).isCloseTo(-2 - 4.302653 / Math.sqrt(3), within(1e-6));
  }

  /** For none of ten, Wilson's interval ends at z² / (10 + z²), z being 1.959964. */
  @Test
  void aShareOfNoneMayBeMore() {
    Estimate none = Estimate.share(0, 10);
    double square = 1.959964 * 1.959964;
    assertThat(none.value()).isZero();
    assertThat(none.low()).isZero();
    assertThat(none.high()).isCloseTo(square / (10 + square), within(1e-6));
    assertThat(Estimate.share(10, 10).high()).isEqualTo(1);
  }
}
