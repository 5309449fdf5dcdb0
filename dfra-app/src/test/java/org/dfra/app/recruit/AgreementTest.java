package org.dfra.app.recruit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.dfra.app.recruit.Agreement.Verdict;
import org.dfra.recruit.experiment.Cell;
import org.dfra.recruit.experiment.CellResult;
import org.dfra.recruit.experiment.Metric;
import org.dfra.recruit.experiment.RunResult;
import org.dfra.recruit.transport.MessageMode;
import org.junit.jupiter.api.Test;

/** That it tells apart what differs, and says no more than it knows of what does not. */
class AgreementTest {

  private static final long SEED = 20261121;
  private static final Cell CELL = new Cell("greedy", MessageMode.BROADCAST, 6, 0);

  /** Runs that take so many seconds to the choice, give or take. */
  private static CellResult runs(int count, double allocation, double spread, RandomGenerator lot) {
    List<RunResult> runs = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      double seconds = allocation + spread * lot.nextGaussian();
      runs.add(new RunResult(i, 3, 3, 3, 33, 66, seconds, 40, 0, 0, 0, 0, 0));
    }
    return new CellResult(CELL, runs);
  }

  private static Agreement allocation(double real, double spread) {
    RandomGenerator lot = new SplittableRandom(SEED);
    return Agreement.all(
            List.of(runs(30, real, spread, lot)),
            List.of(runs(30, 2, spread, lot)),
            List.of(runs(300, 2, spread, lot)))
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
    assertThat(allocation(2.1, 0.01).verdict()).as("seed %s", SEED).isEqualTo(Verdict.CLOSE);
  }

  @Test
  void aGreaterOneDiffers() {
    assertThat(allocation(2.5, 0.1).verdict()).as("seed %s", SEED).isEqualTo(Verdict.DIFFER);
  }

  @Test
  void whatSpreadsTooMuchIsOpen() {
    assertThat(allocation(2, 2).verdict()).as("seed %s", SEED).isEqualTo(Verdict.OPEN);
  }

  /**
   * Of five at 5 %: 0.001 ≤ 0.05/5, 0.012 ≤ 0.05/4, 0.02 > 0.05/3; what follows is not rejected.
   */
  @Test
  void holmRejectsAsLongAsItMay() {
    RandomGenerator lot = new SplittableRandom(SEED);
    CellResult any = runs(2, 2, 0, lot);
    List<Agreement> all = new ArrayList<>();
    for (double p : new double[] {0.02, 0.001, 0.5, 0.012, 0.024}) {
      all.add(
          new Agreement(Metric.ARRIVAL, any, any, 0.5, p, false, Metric.ARRIVAL.more(any, any), 1));
    }
    assertThat(Agreement.holm(all).stream().map(Agreement::isRejected))
        .containsExactly(false, true, false, true, false);
  }
}
