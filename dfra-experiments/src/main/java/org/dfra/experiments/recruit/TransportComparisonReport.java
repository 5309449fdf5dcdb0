package org.dfra.experiments.recruit;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.ToIntFunction;
import java.util.stream.Collectors;
import org.dfra.experiments.recruit.simulation.Experiment.RunResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.CellResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.ExperimentCell;
import org.dfra.experiments.recruit.simulation.Metric;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.report.measurement.ReportHead;
import org.dfra.report.measurement.RunMeasurements;
import org.dfra.report.plot.Axis;
import org.dfra.report.plot.HtmlReport;
import org.dfra.report.plot.LinePanel;
import org.dfra.report.plot.Page;
import org.dfra.report.plot.Series;

/** Writes the comparison of runs over the real network with those over the simulated one. */
final class TransportComparisonReport {

  private static final int HIGH = 230; // pixels of a row

  private final List<TransportComparison> all;
  private final String setting;

  /**
   * @param setting description of the runs
   */
  TransportComparisonReport(List<TransportComparison> all, String setting) {
    this.all = List.copyOf(all);
    this.setting = setting;
  }

  /**
   * Writes it.
   *
   * @return the file to open
   */
  Path write(Path folder) throws IOException {
    HtmlReport html = new HtmlReport("Recruitment strategies compared over remote events");
    ReportHead.add(html, figures(), Instant.now());
    html.paragraph(summary());
    html.heading("Simulated and real transport").paragraph(setting);
    html.paragraph(
        String.format(
            Locale.ROOT,
            "The two-sample Kolmogorov-Smirnov test compares each metric of each cell: runs over the"
                + " real network with runs of other seeds over the simulated one. All %d tests"
                + " together have a level of 5 %%, by Holm's method. The difference is the mean of"
                + " pairs of the same seed, with its interval of 95 %%. The bound of equivalence is"
                + " a tenth of the simulated mean, or %.0f of 100 calls. AGREE: the test is not"
                + " significant, and the interval is within the bound. NEGLIGIBLE: the test is"
                + " significant, but the interval is within the bound. INCONCLUSIVE: the test is not"
                + " significant, but the interval exceeds the bound. DIFFER: the test is significant,"
                + " and the interval exceeds the bound.",
            all.size(),
            TransportComparison.POINTS));
    html.paragraph(violations());
    for (Metric metric : TransportComparison.METRICS) {
      html.heading(ExperimentCharts.sentence(metric.title()));
      html.figure(
          figure(metric),
          "Fraction of the runs with at most this value.",
          folder.resolve(
              "transport-" + metric.name().toLowerCase(Locale.ROOT).replace('_', '-') + ".svg"));
      html.table(
          List.of(
              "Strategy",
              "Messages",
              "Vehicles",
              "Loss",
              "Real",
              "Simulated",
              "Distance",
              "p",
              "Difference real − simulated (95 %)",
              "Bound",
              ""),
          all.stream().filter(each -> each.metric() == metric).map(this::row).toList());
    }
    csv(folder);
    Path file = folder.resolve("report.html");
    html.write(file);
    return file;
  }

  /** The measurements of the real network and their targets. */
  RunMeasurements figures() {
    RunMeasurements figures = new RunMeasurements();
    figures.add(
        new MeasuredValue(
            "second helpers over JERI", violations(RunResult::duplicateHelpers), 0, ""));
    figures.add(
        new MeasuredValue(
            "orphaned helpers over JERI", violations(RunResult::orphanedHelpers), 0, ""));
    figures.add(
        new MeasuredValue(
            "comparisons that differ", count(TransportComparison.Verdict.DIFFER), 0, ""));
    return figures;
  }

  /** The number of comparisons with each result, in a sentence. */
  String summary() {
    return "Of "
        + all.size()
        + " comparisons "
        + Arrays.stream(TransportComparison.Verdict.values())
            .map(each -> count(each) + " " + each)
            .collect(Collectors.joining(", "))
        + ".";
  }

  /** The number of comparisons with that result. */
  private long count(TransportComparison.Verdict verdict) {
    return all.stream().filter(each -> each.verdict() == verdict).count();
  }

  /** Number of violations, over all runs of the real network. */
  private int violations(ToIntFunction<RunResult> what) {
    return all.stream()
        .filter(each -> each.metric() == Metric.FAILURES)
        .mapToInt(each -> each.real().total(what))
        .sum();
  }

  private String violations() {
    return String.format(
        Locale.ROOT,
        "Over the real network, %d calls had %d second helpers and %d orphaned helpers.",
        violations(RunResult::calls),
        violations(RunResult::duplicateHelpers),
        violations(RunResult::orphanedHelpers));
  }

  private List<String> row(TransportComparison each) {
    ExperimentCell cell = each.cell();
    return List.of(
        cell.strategy(),
        StrategyComparisonReport.name(cell.mode()),
        Integer.toString(cell.vehicles()),
        String.format(Locale.ROOT, "%.0f %%", 100 * cell.loss()),
        String.format(Locale.ROOT, "%.2f", each.metric().of(each.real()).value()),
        String.format(Locale.ROOT, "%.2f", each.metric().of(each.simulated()).value()),
        String.format(Locale.ROOT, "%.2f", each.distance()),
        String.format(Locale.ROOT, "%.3f", each.p()),
        each.difference().toString(),
        String.format(Locale.ROOT, "%.2f", each.equivalenceBound()),
        each.verdict().toString());
  }

  /** A row for each strategy and message mode, a panel for each team size and loss. */
  private Page figure(Metric metric) {
    Page page = new Page(ExperimentCharts.sentence(metric.title()) + ": real and simulated");
    List<LinePanel> row = new ArrayList<>();
    String last = "";
    for (TransportComparison each : all.stream().filter(one -> one.metric() == metric).toList()) {
      String kind = each.cell().strategy() + each.cell().mode();
      if (!kind.equals(last) && !row.isEmpty()) {
        page.row(HIGH, row.toArray(LinePanel[]::new));
        row.clear();
      }
      last = kind;
      row.add(panel(each));
    }
    return page.row(HIGH, row.toArray(LinePanel[]::new));
  }

  private static LinePanel panel(TransportComparison each) {
    ExperimentCell cell = each.cell();
    String title =
        String.format(
            Locale.ROOT,
            "%s, %s, %d, %.0f %%",
            cell.strategy(),
            StrategyComparisonReport.name(cell.mode()),
            cell.vehicles(),
            100 * cell.loss());
    return new LinePanel(
            title, Axis.of("", each.metric().unit()), Axis.of("share", "").between(0, 1))
        .add(steps("real", each.metric(), each.real()))
        .add(steps("simulated", each.metric(), each.simulated()));
  }

  private static Series steps(String name, Metric metric, CellResult result) {
    double[] sorted =
        Arrays.stream(result.each(metric::of)).filter(x -> !Double.isNaN(x)).sorted().toArray();
    double[] x = new double[sorted.length + 1];
    double[] y = new double[sorted.length + 1];
    for (int i = 0; i < sorted.length; i++) {
      x[i + 1] = sorted[i];
      y[i + 1] = (i + 1.0) / sorted.length;
    }
    x[0] = sorted.length == 0 ? 0 : sorted[0];
    return Series.steps(name, x, y);
  }

  private void csv(Path folder) throws IOException {
    StringBuilder lines =
        new StringBuilder(
            "strategy,mode,vehicles,loss,metric,unit,real,simulated,ks_distance,p,more,low,high,"
                + "bound,verdict\n");
    for (TransportComparison each : all) {
      ExperimentCell cell = each.cell();
      lines.append(
          String.format(
              Locale.ROOT,
              "%s,%s,%d,%.2f,\"%s\",\"%s\",%.4f,%.4f,%.4f,%.6f,%.4f,%.4f,%.4f,%.4f,%s%n",
              cell.strategy(),
              StrategyComparisonReport.name(cell.mode()),
              cell.vehicles(),
              cell.loss(),
              each.metric().title(),
              each.metric().unit(),
              each.metric().of(each.real()).value(),
              each.metric().of(each.simulated()).value(),
              each.distance(),
              each.p(),
              each.difference().value(),
              each.difference().low(),
              each.difference().high(),
              each.equivalenceBound(),
              each.verdict().name().toLowerCase(Locale.ROOT)));
    }
    Files.writeString(folder.resolve("transport-comparison.csv"), lines);
    List<TransportComparison> cells =
        all.stream().filter(each -> each.metric() == Metric.FAILURES).toList();
    Files.writeString(
        folder.resolve("runs-real.csv"),
        ResultsCsv.of(cells.stream().map(TransportComparison::real).toList()));
    Files.writeString(
        folder.resolve("runs-simulated.csv"),
        ResultsCsv.of(cells.stream().map(TransportComparison::simulated).toList()));
  }
}
