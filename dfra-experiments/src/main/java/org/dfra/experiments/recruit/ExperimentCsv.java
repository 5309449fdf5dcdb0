package org.dfra.experiments.recruit;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.dfra.experiments.recruit.simulation.Estimate;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.CellResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.ExperimentCell;
import org.dfra.experiments.recruit.simulation.Metric;

/** The numbers of an experiment as comma-separated values. */
final class ExperimentCsv {

  private static final String CELL = "strategy,mode,vehicles,loss";

  private final Path folder;

  ExperimentCsv(Path folder) {
    this.folder = folder;
  }

  void write(StrategyComparisonReport comparison) throws IOException {
    Files.writeString(folder.resolve("runs.csv"), ResultsCsv.of(comparison.results()));
    StringBuilder cells = new StringBuilder(CELL + ",metric,unit,value,low,high\n");
    for (CellResult each : comparison.results()) {
      for (Metric metric : Metric.values()) {
        cells
            .append(cell(each.cell()))
            .append(",\"" + metric.title() + "\",\"" + metric.unit() + "\",")
            .append(numbers(metric.of(each)))
            .append('\n');
      }
    }
    Files.writeString(folder.resolve("cells.csv"), cells);
    StringBuilder claims =
        new StringBuilder(CELL + ",rival,metric,unit,affective_more,low,high,verdict\n");
    for (MetricComparison each : comparison.claims()) {
      claims
          .append(cell(each.cell()))
          .append("," + each.rival())
          .append(",\"" + each.metric().title() + "\",\"" + each.metric().unit() + "\",")
          .append(numbers(each.difference()))
          .append("," + each.verdict().name().toLowerCase(Locale.ROOT))
          .append('\n');
    }
    Files.writeString(folder.resolve("claims.csv"), claims);
  }

  private static String cell(ExperimentCell cell) {
    return String.format(
        Locale.ROOT,
        "%s,%s,%d,%.2f",
        cell.strategy(),
        StrategyComparisonReport.name(cell.mode()),
        cell.vehicles(),
        cell.loss());
  }

  private static String numbers(Estimate estimate) {
    return number(estimate.value()) + "," + number(estimate.low()) + "," + number(estimate.high());
  }

  private static String number(double value) {
    return Double.isNaN(value) ? "" : String.format(Locale.ROOT, "%.4f", value);
  }
}
