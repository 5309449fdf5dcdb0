package org.dfra.experiments.recruit;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dfra.experiments.recruit.simulation.Estimate;
import org.dfra.experiments.recruit.simulation.ExperimentGrid;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.CellResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.ExperimentCell;
import org.dfra.experiments.recruit.simulation.Metric;
import org.dfra.recruit.transport.Transport.MessageMode;
import org.dfra.report.plot.Axis;
import org.dfra.report.plot.LinePanel;
import org.dfra.report.plot.Page;
import org.dfra.report.plot.Series;

/**
 * The figures of an experiment. Each has a row for broadcast and one for unicast, a panel for each
 * team size, and in it a line over the loss for each strategy, with confidence intervals.
 * Strategies are slightly offset from each other, so that intervals can be distinguished.
 */
final class ExperimentCharts {

  private static final int HIGH = 300; // pixels of a row
  private static final double BESIDE = 1.1; // per cent of loss
  private static final double ROOM = 0.05; // margin of a vertical axis, at either end
  private static final double MARGIN = 4; // per cent of loss, at the ends of the axis

  private final StrategyComparisonReport comparison;

  ExperimentCharts(StrategyComparisonReport comparison) {
    this.comparison = comparison;
  }

  /** The plotted value of a cell. */
  private interface Value {
    Optional<Estimate> of(ExperimentCell cell);
  }

  /** One metric of all strategies. */
  Page metric(Metric metric) {
    Page page = new Page(sentence(metric.title()));
    for (MessageMode mode : MessageMode.values()) {
      row(
          page,
          mode,
          Axis.of(metric.title(), metric.unit()),
          comparison.strategies(),
          cell -> comparison.of(cell).map(metric::of));
    }
    return page;
  }

  /** Difference between each other strategy and the affective one, which is the line at 0. */
  Page difference(Metric metric) {
    Page page =
        new Page(sentence(metric.title()) + ": other strategies minus affective, paired by seed");
    for (MessageMode mode : MessageMode.values()) {
      row(
          page,
          mode,
          Axis.of("other minus affective", metric.unit()),
          comparison.strategies(),
          cell -> more(metric, cell));
    }
    return page;
  }

  private Optional<Estimate> more(Metric metric, ExperimentCell cell) {
    Optional<CellResult> affective = comparison.of(cell.with(MetricComparison.AFFECTIVE));
    return comparison.of(cell).flatMap(it -> affective.map(other -> metric.difference(it, other)));
  }

  private static void row(Page page, MessageMode mode, Axis up, List<String> names, Value value) {
    List<LinePanel> panels = new ArrayList<>();
    List<Double> ends = new ArrayList<>(List.of(0.0));
    for (int vehicles : ExperimentGrid.VEHICLES) {
      for (String name : names) {
        for (double loss : ExperimentGrid.LOSSES) {
          value
              .of(new ExperimentCell(name, mode, vehicles, loss))
              .ifPresent(
                  each -> {
                    ends.add(finite(each.low(), each.value()));
                    ends.add(finite(each.high(), each.value()));
                  });
        }
      }
    }
    Axis scaled = scaled(up, ends);
    for (int vehicles : ExperimentGrid.VEHICLES) {
      panels.add(panel(mode, vehicles, scaled, names, value));
    }
    page.row(HIGH, panels.toArray(LinePanel[]::new));
  }

  /** With an initial capital. */
  static String sentence(String text) {
    return text.substring(0, 1).toUpperCase(Locale.ROOT) + text.substring(1);
  }

  private static double finite(double end, double otherwise) {
    return Double.isFinite(end) ? end : otherwise;
  }

  /** All panels of a row have one scale, so that they can be compared. */
  private static Axis scaled(Axis up, List<Double> ends) {
    List<Double> known = ends.stream().filter(Double::isFinite).toList();
    double low = Collections.min(known);
    double high = Collections.max(known);
    if (low == high) {
      return up.between(-ROOM, 1); // nothing but zeros
    }
    double margin = ROOM * (high - low);
    return up.between(low - margin, high + margin);
  }

  private static LinePanel panel(
      MessageMode mode, int vehicles, Axis up, List<String> names, Value value) {
    Axis across = Axis.of("loss", "%").between(-MARGIN, 50 + MARGIN);
    LinePanel panel =
        new LinePanel(
            StrategyComparisonReport.name(mode) + ", " + vehicles + " vehicles", across, up);
    for (int i = 0; i < names.size(); i++) {
      List<double[]> points = new ArrayList<>();
      List<double[]> bars = new ArrayList<>();
      for (double loss : ExperimentGrid.LOSSES) {
        double x = 100 * loss + (i - (names.size() - 1) / 2.0) * BESIDE;
        value
            .of(new ExperimentCell(names.get(i), mode, vehicles, loss))
            .ifPresent(
                each -> {
                  points.add(new double[] {x, each.value()});
                  bars.add(new double[] {x, each.low()});
                  bars.add(new double[] {x, each.high()});
                  bars.add(new double[] {x, Double.NaN}); // the next one is a single panel
                });
      }
      panel.add(
          Series.line(names.get(i), all(points, 0), all(points, 1)),
          Series.line(names.get(i), all(bars, 0), all(bars, 1)),
          Series.points(names.get(i), all(points, 0), all(points, 1)));
    }
    return panel;
  }

  private static double[] all(List<double[]> points, int index) {
    return points.stream().mapToDouble(each -> each[index]).toArray();
  }
}
