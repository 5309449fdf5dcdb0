package org.dfra.experiments.recruit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.apache.commons.statistics.inference.KolmogorovSmirnovTest;
import org.dfra.experiments.recruit.simulation.Estimate;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.CellResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.ExperimentCell;
import org.dfra.experiments.recruit.simulation.Metric;

/**
 * Compares the distributions of runs over the real network and over the simulated one.
 *
 * <p>Each metric of each cell is compared by the two-sample Kolmogorov-Smirnov test on independent
 * runs, and all of these together by Holm's method at 5 %. A test that does not reject does not
 * prove equality. Therefore the difference of the means, of pairs with the same seed, has a
 * confidence interval of 95 %; within {@link #equivalenceBound} the two count as equal for the
 * experiment's claims.
 *
 * @param distance largest between the two distribution functions, 0 to 1
 * @param p probability of such a distance, or a larger one, if the two are equal
 * @param isRejected whether Holm's method rejects their equality
 * @param difference mean over the real network minus the simulated one
 * @param equivalenceBound maximum difference that counts as equal
 */
record TransportComparison(
    Metric metric,
    CellResult real,
    CellResult simulated,
    double distance,
    double p,
    boolean isRejected,
    Estimate difference,
    double equivalenceBound) {

  /** Maximum probability that any comparison rejects although all are equal. */
  static final double LEVEL = 0.05;

  /** The bound as a share of the simulated mean. */
  static final double SHARE = 0.1;

  /** The bound for failed calls, percent of all. */
  static final double POINTS = 5;

  /** The compared metrics. */
  static final List<Metric> METRICS =
      List.of(Metric.TRANSMISSIONS, Metric.ALLOCATION, Metric.ARRIVAL, Metric.FAILURES);

  /** The result of a comparison. */
  enum Verdict {
    /** Not significant, and the interval is within the bound. */
    AGREE,
    /** Significant, but the interval is within the bound. */
    NEGLIGIBLE,
    /** Not significant, but the interval is too wide. */
    INCONCLUSIVE,
    /** Significant, and the interval exceeds the bound. */
    DIFFER
  }

  ExperimentCell cell() {
    return real.cell();
  }

  /** The result. */
  Verdict verdict() {
    boolean isWithin =
        -equivalenceBound <= difference.low() && difference.high() <= equivalenceBound;
    if (isRejected) {
      return isWithin ? Verdict.NEGLIGIBLE : Verdict.DIFFER;
    }
    return isWithin ? Verdict.AGREE : Verdict.INCONCLUSIVE;
  }

  /**
   * Compares all cells.
   *
   * @param real a result for each cell
   * @param paired over the simulated network with the same seeds, cell by cell
   * @param others over it with other seeds, cell by cell
   */
  static List<TransportComparison> all(
      List<CellResult> real, List<CellResult> paired, List<CellResult> others) {
    List<TransportComparison> found = new ArrayList<>();
    for (int i = 0; i < real.size(); i++) {
      for (Metric metric : METRICS) {
        found.add(of(metric, real.get(i), paired.get(i), others.get(i)));
      }
    }
    return holm(found);
  }

  private static TransportComparison of(
      Metric metric, CellResult real, CellResult paired, CellResult others) {
    double[] here = measured(metric, real);
    double[] there = measured(metric, others);
    double distance = 0;
    double p = 1;
    if (here.length > 1 && there.length > 1) {
      var result = KolmogorovSmirnovTest.withDefaults().test(here, there);
      distance = result.getStatistic();
      p = result.getPValue();
    }
    Estimate more = metric.difference(real, paired);
    double bound =
        metric == Metric.FAILURES
            ? POINTS
            : SHARE * Arrays.stream(there).average().orElse(Double.NaN);
    return new TransportComparison(metric, real, others, distance, p, false, more, bound);
  }

  private static double[] measured(Metric metric, CellResult result) {
    return Arrays.stream(result.each(metric::of)).filter(each -> !Double.isNaN(each)).toArray();
  }

  /**
   * Rejects the least probable ones, as long as the n-th of m is below {@link #LEVEL} / (m - n +
   * 1). Source: S. Holm, "A simple sequentially rejective multiple test procedure", Scandinavian
   * Journal of Statistics 6 (1979).
   */
  static List<TransportComparison> holm(List<TransportComparison> all) {
    List<TransportComparison> byP =
        all.stream().sorted(Comparator.comparingDouble(TransportComparison::p)).toList();
    int rejected = 0;
    while (rejected < byP.size() && byP.get(rejected).p() <= LEVEL / (byP.size() - rejected)) {
      rejected++;
    }
    List<TransportComparison> first = byP.subList(0, rejected);
    return all.stream().map(each -> each.withRejected(first.contains(each))).toList();
  }

  private TransportComparison withRejected(boolean is) {
    return new TransportComparison(
        metric, real, simulated, distance, p, is, difference, equivalenceBound);
  }
}
