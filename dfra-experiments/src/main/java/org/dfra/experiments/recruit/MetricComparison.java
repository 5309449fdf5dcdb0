package org.dfra.experiments.recruit;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.dfra.experiments.recruit.simulation.Estimate;
import org.dfra.experiments.recruit.simulation.ExperimentGrid;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.CellResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.ExperimentCell;
import org.dfra.experiments.recruit.simulation.Metric;

/**
 * Compares the affective strategy with another in a cell, by one metric. It claims only a sign, and
 * only where the confidence interval of the paired difference excludes 0.
 *
 * @param cell the affective one
 * @param rival the other strategy
 * @param difference affective minus rival; below 0 the affective strategy is better
 * @param relativeDifference the same relative to the rival's value; NaN where that is 0
 */
record MetricComparison(
    Metric metric,
    ExperimentCell cell,
    String rival,
    Estimate difference,
    double relativeDifference) {

  /** The strategy compared with all others. */
  public static final String AFFECTIVE = "affective";

  /** The conclusion that the intervals permit. */
  public enum Outcome {
    WINS,
    LOSES,
    /** The interval contains 0: no difference was found. */
    INCONCLUSIVE
  }

  /** Whether the affective strategy is better. */
  public Outcome verdict() {
    if (difference.high() < 0) {
      return Outcome.WINS;
    }
    return difference.low() > 0 ? Outcome.LOSES : Outcome.INCONCLUSIVE;
  }

  /** All comparisons, in the order of the cells. */
  public static List<MetricComparison> all(List<CellResult> results) {
    Map<ExperimentCell, CellResult> byCell = new HashMap<>();
    results.forEach(result -> byCell.put(result.cell(), result));
    List<MetricComparison> claims = new ArrayList<>();
    for (CellResult result : results) {
      if (!result.cell().strategy().equals(AFFECTIVE)) {
        continue;
      }
      for (String rival : ExperimentGrid.strategies(results)) {
        CellResult other = byCell.get(result.cell().with(rival));
        if (!rival.equals(AFFECTIVE) && other != null) {
          for (Metric metric : Metric.values()) {
            claims.add(of(metric, result, other));
          }
        }
      }
    }
    return claims;
  }

  private static MetricComparison of(Metric metric, CellResult affective, CellResult other) {
    Estimate more = metric.difference(affective, other);
    double there = metric.of(other).value();
    return new MetricComparison(
        metric,
        affective.cell(),
        other.cell().strategy(),
        more,
        there == 0 ? Double.NaN : more.value() / there);
  }

  /** {@code affective, broadcast, 6 vehicles, 10 % loss: less transmissions than greedy: …}. */
  @Override
  public String toString() {
    String verb =
        switch (verdict()) {
          case WINS -> "less than " + rival;
          case LOSES -> "more than " + rival;
          case INCONCLUSIVE -> "no difference to " + rival + " was seen";
        };
    return String.format(Locale.ROOT, "%s: %s, %s: %s", cell, metric.title(), verb, difference);
  }
}
