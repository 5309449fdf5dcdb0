package org.dfra.experiments.recruit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.dfra.experiments.recruit.MetricComparison.Outcome;
import org.dfra.experiments.recruit.simulation.Experiment.RunResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.CellResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.ExperimentCell;
import org.dfra.experiments.recruit.simulation.Metric;
import org.dfra.recruit.transport.Transport.MessageMode;
import org.junit.jupiter.api.Test;

/** What is written and claimed of results, on results made by hand. */
class ResultsTest {

  private static final ExperimentCell AFFECTIVE =
      new ExperimentCell("affective", MessageMode.BROADCAST, 6, 0.25);

  private static RunResult run(long seed, long transmissions, double allocation) {
    return new RunResult(
        seed, 12, 10, 9, transmissions, 2 * transmissions, allocation, 41.5, 0.25, 1, 2, 30, 7.125);
  }

  private static CellResult cell(String strategy, long... transmissions) {
    List<RunResult> runs = new ArrayList<>();
    for (int i = 0; i < transmissions.length; i++) {
      runs.add(run(i, transmissions[i], 4));
    }
    return new CellResult(AFFECTIVE.with(strategy), runs);
  }

  @Test
  void aLineOfTheCsvIsARun() {
    CellResult result = new CellResult(AFFECTIVE, List.of(run(7, 95, 3.5), run(8, 96, Double.NaN)));
    assertThat(ResultsCsv.of(List.of(result)).lines())
        .containsExactly(
            "strategy,mode,vehicles,loss,seed,calls,completed,successes,transmissions,receptions,"
                + "allocation_s,arrival_s,regret_s,duplicate_helpers,orphaned_helpers,raster_time_lost_s,travel_m",
            "affective,broadcast,6,0.25,7,12,10,9,95,190,3.500,41.500,0.250,1,2,30.000,7.125",
            "affective,broadcast,6,0.25,8,12,10,9,96,192,,41.500,0.250,1,2,30.000,7.125");
  }

  private static MetricComparison claim(CellResult affective, CellResult rival) {
    return MetricComparison.all(List.of(affective, rival)).stream()
        .filter(each -> each.metric() == Metric.TRANSMISSIONS)
        .findFirst()
        .orElseThrow();
  }

  @Test
  void aWinIsAnIntervalBelowNothing() {
    MetricComparison claim = claim(cell("affective", 80, 81, 82), cell("greedy", 100, 102, 103));
    assertThat(claim.verdict()).isEqualTo(Outcome.WINS);
    assertThat(claim.difference().value()).as("each").isCloseTo(-62.0 / 3 / 10, within(1e-9));
    assertThat(claim.relativeDifference()).isCloseTo(-62.0 / 305, within(1e-9));
    assertThat(claim)
        .hasToString(
            "affective, broadcast, 6 vehicles, 25 % loss: transmissions, less than greedy: "
                + claim.difference());
  }

  @Test
  void aLossIsOneAboveAndWhatHoldsNothingIsOpen() {
    assertThat(claim(cell("affective", 120, 121, 122), cell("greedy", 100, 100, 100)).verdict())
        .isEqualTo(Outcome.LOSES);
    assertThat(claim(cell("affective", 90, 101, 109), cell("greedy", 100, 100, 100)).verdict())
        .isEqualTo(Outcome.INCONCLUSIVE);
  }

  @Test
  void everyRivalIsComparedByEveryMetricAndAffectiveNotWithItself() {
    List<MetricComparison> claims =
        MetricComparison.all(
            List.of(cell("affective", 1, 2), cell("greedy", 1, 2), cell("random", 1, 3)));
    assertThat(claims).hasSize(2 * Metric.values().length);
    assertThat(claims.stream().map(MetricComparison::rival).distinct())
        .containsExactly("greedy", "random");
    assertThat(MetricComparison.all(List.of(cell("greedy", 1, 2)))).isEmpty();
  }
}
