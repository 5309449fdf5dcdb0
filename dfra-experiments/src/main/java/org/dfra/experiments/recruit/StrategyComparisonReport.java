package org.dfra.experiments.recruit;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dfra.experiments.recruit.MetricComparison.Outcome;
import org.dfra.experiments.recruit.simulation.Estimate;
import org.dfra.experiments.recruit.simulation.Experiment.RunResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.CellResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.ExperimentCell;
import org.dfra.experiments.recruit.simulation.Metric;
import org.dfra.recruit.transport.Transport.MessageMode;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.report.measurement.RunMeasurements;

/** Summarises the results of an experiment. */
final class StrategyComparisonReport {

  private static final double MAX_MILD_LOSS = 0.25; // maximum loss of the cells with targets
  private static final int TEAM = 6; // minimum number of vehicles of these cells
  private static final double MOST_FAILED = 0.01;

  private final List<CellResult> results;
  private final List<MetricComparison> claims;

  StrategyComparisonReport(List<CellResult> results) {
    this.results = List.copyOf(results);
    this.claims = List.copyOf(MetricComparison.all(results));
  }

  List<CellResult> results() {
    return results;
  }

  List<String> strategies() {
    return ExperimentGrid.strategies(results);
  }

  List<MetricComparison> claims() {
    return claims;
  }

  Optional<CellResult> of(ExperimentCell cell) {
    return results.stream().filter(each -> each.cell().equals(cell)).findFirst();
  }

  /** Number of cells in which the affective strategy has this result against a rival. */
  long count(MessageMode mode, String rival, Metric metric, Outcome verdict) {
    return claims.stream()
        .filter(each -> each.cell().mode() == mode && each.rival().equals(rival))
        .filter(each -> each.metric() == metric && each.verdict() == verdict)
        .count();
  }

  /** Those in which it loses. */
  List<MetricComparison> losses() {
    return claims.stream().filter(each -> each.verdict() == Outcome.LOSES).toList();
  }

  /** The measurements and their targets. */
  RunMeasurements figures() {
    RunMeasurements figures = new RunMeasurements();
    List<CellResult> mild =
        results.stream()
            .filter(each -> ExperimentGrid.STRATEGIES.contains(each.cell().strategy()))
            .filter(each -> each.cell().loss() <= MAX_MILD_LOSS)
            .toList();
    figures.add(
        new MeasuredValue(
            "second helpers at a loss up to 25 %", sum(mild, Metric.DUPLICATE_HELPERS), 0, ""));
    figures.add(
        new MeasuredValue(
            "orphaned helpers at a loss up to 25 %", sum(mild, Metric.ORPHANED_HELPERS), 0, ""));
    for (MessageMode mode : MessageMode.values()) {
      for (int vehicles : teams()) {
        String what = name(mode) + ", " + vehicles + " vehicles, 25 %: calls without help in time";
        share(what, new ExperimentCell(MetricComparison.AFFECTIVE, mode, vehicles, MAX_MILD_LOSS))
            .ifPresent(figures::add);
      }
    }
    for (MetricComparison each : claims) {
      if (isWanted(each)) {
        ExperimentCell cell = each.cell();
        String what =
            String.format(
                Locale.ROOT,
                "transmissions over greedy's, %d vehicles, %.0f %%, upper end",
                cell.vehicles(),
                100 * cell.loss());
        figures.add(new MeasuredValue(what, each.difference().high(), 0, ""));
      }
    }
    return figures;
  }

  private static boolean isWanted(MetricComparison claim) {
    return claim.metric() == Metric.TRANSMISSIONS
        && claim.rival().equals("greedy")
        && claim.cell().mode() == MessageMode.BROADCAST
        && claim.cell().vehicles() >= TEAM
        && claim.cell().loss() <= MAX_MILD_LOSS;
  }

  private static List<Integer> teams() {
    return ExperimentGrid.VEHICLES.stream().filter(each -> each >= TEAM).toList();
  }

  private Optional<MeasuredValue> share(String what, ExperimentCell cell) {
    return of(cell)
        .map(each -> new MeasuredValue(what, 1 - each.success().value(), MOST_FAILED, ""));
  }

  private static double sum(List<CellResult> results, Metric metric) {
    return results.stream().flatMap(each -> each.runs().stream()).mapToDouble(metric::of).sum();
  }

  /** A short summary: transmissions first, since reducing them is the strategy's purpose. */
  List<String> sentences() {
    List<String> sentences = new ArrayList<>();
    for (MessageMode mode : MessageMode.values()) {
      for (String rival : strategies()) {
        if (!rival.equals(MetricComparison.AFFECTIVE)) {
          sentences.add(sentence(mode, rival));
        }
      }
    }
    return sentences;
  }

  private String sentence(MessageMode mode, String rival) {
    Metric metric = Metric.TRANSMISSIONS;
    return String.format(
        Locale.ROOT,
        "By %s affective recruitment takes fewer transmissions than %s in %d of %d cells, MORE in"
            + " %d, and no difference was seen in %d.",
        name(mode),
        rival,
        count(mode, rival, metric, Outcome.WINS),
        ExperimentGrid.VEHICLES.size() * ExperimentGrid.LOSSES.size(),
        count(mode, rival, metric, Outcome.LOSES),
        count(mode, rival, metric, Outcome.INCONCLUSIVE));
  }

  /** Number of calls and of failed calls, over all runs of the cells with targets. */
  Estimate failedMildly() {
    int calls = 0;
    int failed = 0;
    for (CellResult each : results) {
      if (each.cell().strategy().equals(MetricComparison.AFFECTIVE)
          && each.cell().loss() <= MAX_MILD_LOSS) {
        calls += each.total(RunResult::calls);
        failed += each.total(run -> run.calls() - run.successes());
      }
    }
    return Estimate.share(failed, calls);
  }

  static String name(MessageMode mode) {
    return mode.name().toLowerCase(Locale.ROOT);
  }
}
