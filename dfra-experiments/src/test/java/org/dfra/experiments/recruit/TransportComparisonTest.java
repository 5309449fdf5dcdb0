package org.dfra.experiments.recruit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.dfra.experiments.recruit.TransportComparison.Verdict;
import org.dfra.experiments.recruit.simulation.Experiment.RunResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.CellResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.ExperimentCell;
import org.dfra.experiments.recruit.simulation.Metric;
import org.dfra.recruit.transport.Transport.MessageMode;
import org.junit.jupiter.api.Test;

/** That it tells apart what differs, and says no more than it knows of what does not. */
class TransportComparisonTest {

  private static final long SEED = 20261121;
  private static final ExperimentCell CELL =
      new ExperimentCell("greedy", MessageMode.BROADCAST, 6, 0);

  /** Runs that take so many seconds to the choice, give or take. */
  private static CellResult runs(
      int count, double allocation, double spread, RandomGenerator random) {
    List<RunResult> runs = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      double seconds = allocation + spread * random.nextGaussian();
      runs.add(new RunResult(i, 3, 3, 3, 33, 66, seconds, 40, 0, 0, 0, 0, 0));
    }
    return new CellResult(CELL, runs);
  }

  private static TransportComparison allocation(double real, double spread) {
    RandomGenerator random = new SplittableRandom(SEED);
    return TransportComparison.all(
            List.of(runs(30, real, spread, random)),
            List.of(runs(30, 2, spread, random)),
            List.of(runs(300, 2, spread, random)))
        .stream()
        .filter(each -> each.metric() == Metric.ALLOCATION)
        .findFirst()
        .orElseThrow();
  }

  @Test
  void theSameAgrees() {
    assertThat(allocation(2, 0.1).verdict()).as("seed %s", SEED).isEqualTo(Verdict.AGREE);
  }

  @Test
  void aDifferenceWithinATenthIsClose() {
    assertThat(allocation(2.1, 0.01).verdict()).as("seed %s", SEED).isEqualTo(Verdict.NEGLIGIBLE);
  }

  @Test
  void aGreaterOneDiffers() {
    assertThat(allocation(2.5, 0.1).verdict()).as("seed %s", SEED).isEqualTo(Verdict.DIFFER);
  }

  @Test
  void whatSpreadsTooMuchIsOpen() {
    assertThat(allocation(2, 2).verdict()).as("seed %s", SEED).isEqualTo(Verdict.INCONCLUSIVE);
  }

  /**
   * Of five at 5 %: 0.001 ≤ 0.05/5, 0.012 ≤ 0.05/4, 0.02 > 0.05/3; what follows is not rejected.
   */
  @Test
  void holmRejectsAsLongAsItMay() {
    RandomGenerator random = new SplittableRandom(SEED);
    CellResult any = runs(2, 2, 0, random);
    List<TransportComparison> all = new ArrayList<>();
    for (double p : new double[] {0.02, 0.001, 0.5, 0.012, 0.024}) {
      all.add(
          new TransportComparison(
              Metric.ARRIVAL, any, any, 0.5, p, false, Metric.ARRIVAL.difference(any, any), 1));
    }
    assertThat(TransportComparison.holm(all).stream().map(TransportComparison::isRejected))
        .containsExactly(false, true, false, true, false);
  }
}
