package org.dfra.experiments.recruit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dfra.experiments.recruit.MetricComparison.Outcome;
import org.dfra.experiments.recruit.simulation.Experiment.RunResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.CellResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.ExperimentCell;
import org.dfra.experiments.recruit.simulation.Metric;
import org.dfra.recruit.transport.Transport.MessageMode;
import org.dfra.report.measurement.MeasuredValue;
import org.junit.jupiter.api.Test;

/** What results come to, on results made by hand. */
class StrategyComparisonReportTest {

  private static final int CALLS = 12;

  /** Three runs of which the n-th took so many transmissions for each recruitment and n more. */
  private static CellResult runs(ExperimentCell cell, int transmissions, int failed, int doubles) {
    List<RunResult> runs = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      int completed = CALLS - failed;
      long sent = (long) completed * (transmissions + i);
      runs.add(
          new RunResult(
              i, CALLS, completed, completed, sent, sent, 4, 50, 1, doubles, 0, 10 + i, 100));
    }
    return new CellResult(cell, runs);
  }

  private static StrategyComparisonReport of(int affective, int failed, int doubles) {
    List<CellResult> results = new ArrayList<>();
    for (ExperimentCell cell : ExperimentGrid.cells()) {
      boolean isAffective = cell.strategy().equals("affective");
      results.add(runs(cell, isAffective ? affective : 20, isAffective ? failed : 0, doubles));
    }
    return new StrategyComparisonReport(results);
  }

  private static List<String> missed(StrategyComparisonReport comparison) {
    return comparison.figures().missed().stream().map(MeasuredValue::name).toList();
  }

  @Test
  void findsNothingMissedWhereAllIsWell() {
    StrategyComparisonReport comparison = of(9, 0, 0);
    assertThat(missed(comparison)).isEmpty();
    // 2 of doubles and orphans, 4 of calls without help, 6 of transmissions
    assertThat(comparison.figures().all()).hasSize(12);
    assertThat(comparison.losses()).isEmpty();
    assertThat(comparison.count(MessageMode.UNICAST, "greedy", Metric.TRANSMISSIONS, Outcome.WINS))
        .isEqualTo(12);
    assertThat(comparison.count(MessageMode.UNICAST, "greedy", Metric.TRAVEL, Outcome.INCONCLUSIVE))
        .isEqualTo(12);
  }

  @Test
  void saysWhereItLoses() {
    StrategyComparisonReport comparison = of(21, 0, 0);
    assertThat(missed(comparison)).hasSize(6).allMatch(each -> each.startsWith("transmissions"));
    assertThat(comparison.sentences())
        .contains(
            "By broadcast affective recruitment takes fewer transmissions than greedy in 0 of 12"
                + " cells, MORE in 12, and no difference was seen in 0.");
  }

  @Test
  void missesWhatFailsAndWhatIsDouble() {
    assertThat(missed(of(9, 1, 0)))
        .hasSize(4)
        .allMatch(each -> each.endsWith("calls without help in time"));
    assertThat(missed(of(9, 0, 1))).containsExactly("second helpers at a loss up to 25 %");
  }
}
