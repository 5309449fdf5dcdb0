package org.dfra.experiments.recruit;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dfra.experiments.recruit.simulation.Estimate;
import org.dfra.experiments.recruit.simulation.ExperimentGrid;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.CellResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.ExperimentCell;
import org.dfra.experiments.recruit.simulation.Metric;

/**
 * The change of a metric of one strategy between two cells that differ in one parameter. Both have
 * the same seeds, and the seed determines the call positions: the runs are pairs.
 *
 * @param difference second minus first
 */
record Trend(Metric metric, ExperimentCell from, ExperimentCell to, Estimate difference) {

  /** The sign of the interval: 1 increase, -1 decrease, 0 no change found. */
  public int sign() {
    if (difference.low() > 0) {
      return 1;
    }
    return difference.high() < 0 ? -1 : 0;
  }

  /** From the smallest team to the largest, without loss and at a quarter. */
  public static List<Trend> byTeam(List<CellResult> results, Metric metric) {
    int small = ExperimentGrid.VEHICLES.get(0);
    int large = ExperimentGrid.VEHICLES.get(ExperimentGrid.VEHICLES.size() - 1);
    List<Trend> trends = new ArrayList<>();
    for (CellResult each : results) {
      ExperimentCell cell = each.cell();
      if (cell.vehicles() == small && (cell.loss() == 0 || cell.loss() == 0.25)) {
        ExperimentCell to = new ExperimentCell(cell.strategy(), cell.mode(), large, cell.loss());
        of(results, metric, cell, to).ifPresent(trends::add);
      }
    }
    return trends;
  }

  /** From no loss to a quarter, in every team. */
  public static List<Trend> byLoss(List<CellResult> results, Metric metric) {
    List<Trend> trends = new ArrayList<>();
    for (CellResult each : results) {
      ExperimentCell cell = each.cell();
      if (cell.loss() == 0) {
        ExperimentCell to = new ExperimentCell(cell.strategy(), cell.mode(), cell.vehicles(), 0.25);
        of(results, metric, cell, to).ifPresent(trends::add);
      }
    }
    return trends;
  }

  private static Optional<Trend> of(
      List<CellResult> results, Metric metric, ExperimentCell from, ExperimentCell to) {
    Map<ExperimentCell, CellResult> byCell = new HashMap<>();
    results.forEach(result -> byCell.put(result.cell(), result));
    CellResult first = byCell.get(from);
    CellResult second = byCell.get(to);
    return first == null || second == null
        ? Optional.empty()
        : Optional.of(new Trend(metric, from, to, metric.difference(second, first)));
  }
}
