package org.dfra.experiments.recruit;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.dfra.experiments.recruit.MetricComparison.Outcome;
import org.dfra.experiments.recruit.simulation.Estimate;
import org.dfra.experiments.recruit.simulation.Experiment.RunResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.ExperimentCell;
import org.dfra.experiments.recruit.simulation.Metric;
import org.dfra.recruit.transport.Transport.MessageMode;
import org.dfra.report.plot.HtmlReport;

/** The tables of an experiment's report. */
final class ExperimentTables {

  private final StrategyComparisonReport comparison;
  private final HtmlReport html;

  ExperimentTables(StrategyComparisonReport comparison, HtmlReport html) {
    this.comparison = comparison;
    this.html = html;
  }

  /** Number of cells in which the affective strategy wins and loses. */
  void verdicts() {
    List<List<String>> rows = new ArrayList<>();
    for (MessageMode mode : MessageMode.values()) {
      for (String rival : rivals()) {
        for (Metric metric : Metric.values()) {
          rows.add(
              List.of(
                  StrategyComparisonReport.name(mode),
                  rival,
                  title(metric),
                  count(mode, rival, metric, Outcome.WINS),
                  count(mode, rival, metric, Outcome.LOSES),
                  count(mode, rival, metric, Outcome.INCONCLUSIVE)));
        }
      }
    }
    html.table(
        List.of(
            "Messages",
            "Against",
            "Metric, less is better",
            "Wins",
            "Losses",
            "No difference seen"),
        rows);
  }

  private String count(MessageMode mode, String rival, Metric metric, Outcome verdict) {
    return Long.toString(comparison.count(mode, rival, metric, verdict));
  }

  private List<String> rivals() {
    return comparison.strategies().stream()
        .filter(each -> !each.equals(MetricComparison.AFFECTIVE))
        .toList();
  }

  /** Every significant comparison of one metric. */
  void claims(Metric metric) {
    List<List<String>> rows = new ArrayList<>();
    for (MetricComparison each : comparison.claims()) {
      if (each.metric() == metric && each.verdict() != Outcome.INCONCLUSIVE) {
        rows.add(row(each));
      }
    }
    if (rows.isEmpty()) {
      html.paragraph("No difference was seen in any cell.");
    } else {
      html.table(claimHeadings(), rows);
    }
  }

  private static List<String> claimHeadings() {
    return List.of(
        "Messages",
        "Vehicles",
        "Loss",
        "Against",
        "Affective",
        "Affective − other (95 %)",
        "Relative to the other's");
  }

  private static List<String> row(MetricComparison claim) {
    ExperimentCell cell = claim.cell();
    return List.of(
        StrategyComparisonReport.name(cell.mode()),
        Integer.toString(cell.vehicles()),
        percent(cell.loss()),
        claim.rival(),
        claim.verdict() == Outcome.WINS ? "wins" : "LOSES",
        claim.difference().toString(),
        Double.isNaN(claim.relativeDifference())
            ? ""
            : String.format(Locale.ROOT, "%+.0f %%", 100 * claim.relativeDifference()));
  }

  /** Every cell's value of a metric, for one mode of messages to all. */
  void metric(Metric metric, MessageMode mode) {
    List<String> headings =
        Stream.concat(Stream.of("Vehicles", "Loss"), comparison.strategies().stream()).toList();
    List<List<String>> rows = new ArrayList<>();
    for (int vehicles : ExperimentGrid.VEHICLES) {
      for (double loss : ExperimentGrid.LOSSES) {
        List<String> row = new ArrayList<>(List.of(Integer.toString(vehicles), percent(loss)));
        for (String strategy : comparison.strategies()) {
          row.add(value(metric, new ExperimentCell(strategy, mode, vehicles, loss)));
        }
        rows.add(row);
      }
    }
    html.table(headings, rows);
  }

  private String value(Metric metric, ExperimentCell cell) {
    return comparison
        .of(cell)
        .map(
            each ->
                switch (metric) {
                  case DUPLICATE_HELPERS ->
                      Integer.toString(each.total(RunResult::duplicateHelpers));
                  case ORPHANED_HELPERS -> Integer.toString(each.total(RunResult::orphanedHelpers));
                  case FAILURES ->
                      each.total(run -> run.calls() - run.successes())
                          + " of "
                          + each.total(RunResult::calls)
                          + ": "
                          + metric.of(each);
                  default -> text(metric.of(each));
                })
        .orElse("");
  }

  private static String text(Estimate estimate) {
    return Double.isNaN(estimate.value()) ? "no data" : estimate.toString();
  }

  /** How a metric depends on the team size and on the loss. */
  void trends(Metric metric) {
    List<List<String>> rows = new ArrayList<>();
    for (Trend each : Trend.byTeam(comparison.results(), metric)) {
      rows.add(
          row(
              each,
              each.from().vehicles() + " to " + each.to().vehicles() + " vehicles",
              percent(each.from().loss()) + " loss"));
    }
    for (Trend each : Trend.byLoss(comparison.results(), metric)) {
      rows.add(
          row(
              each,
              percent(each.from().loss()) + " to " + percent(each.to().loss()) + " loss",
              each.from().vehicles() + " vehicles"));
    }
    html.table(List.of("Messages", "Strategy", "From … to", "At", "Trend", "By (95 %)"), rows);
  }

  private static List<String> row(Trend trend, String way, String at) {
    return List.of(
        StrategyComparisonReport.name(trend.from().mode()),
        trend.from().strategy(),
        way,
        at,
        switch (trend.sign()) {
          case 1 -> "grows";
          case -1 -> "falls";
          default -> "no change was seen";
        },
        trend.difference().toString());
  }

  static String title(Metric metric) {
    return metric.title() + ", " + metric.unit();
  }

  private static String percent(double share) {
    return String.format(Locale.ROOT, "%.0f %%", 100 * share);
  }
}
