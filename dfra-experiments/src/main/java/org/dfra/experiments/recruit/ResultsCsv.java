package org.dfra.experiments.recruit;

import java.util.List;
import java.util.Locale;
import java.util.StringJoiner;
import org.dfra.experiments.recruit.simulation.Experiment.RunResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.CellResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.ExperimentCell;

/** The results as comma-separated values: one row for each run, without averages. */
final class ResultsCsv {

  private static final String HEAD =
      "strategy,mode,vehicles,loss,seed,calls,completed,successes,transmissions,receptions,"
          + "allocation_s,arrival_s,regret_s,duplicate_helpers,orphaned_helpers,raster_time_lost_s,travel_m";

  private ResultsCsv() {}

  /**
   * All rows, the first with the names of the columns. Numbers that were not measured are empty.
   */
  public static String of(List<CellResult> results) {
    StringJoiner lines = new StringJoiner("\n", HEAD + "\n", "\n");
    for (CellResult result : results) {
      for (RunResult run : result.runs()) {
        lines.add(line(result.cell(), run));
      }
    }
    return lines.toString();
  }

  private static String line(ExperimentCell cell, RunResult run) {
    return String.format(
        Locale.ROOT,
        "%s,%s,%d,%.2f,%d,%d,%d,%d,%d,%d,%s,%s,%s,%d,%d,%s,%s",
        cell.strategy(),
        cell.mode().name().toLowerCase(Locale.ROOT),
        cell.vehicles(),
        cell.loss(),
        run.seed(),
        run.calls(),
        run.completed(),
        run.successes(),
        run.transmissions(),
        run.receptions(),
        number(run.allocation()),
        number(run.arrival()),
        number(run.regret()),
        run.duplicateHelpers(),
        run.orphanedHelpers(),
        number(run.rasterTimeLost()),
        number(run.travel()));
  }

  private static String number(double value) {
    return Double.isNaN(value) ? "" : String.format(Locale.ROOT, "%.3f", value);
  }
}
