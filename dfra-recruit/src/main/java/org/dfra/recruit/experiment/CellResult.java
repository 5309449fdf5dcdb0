package org.dfra.recruit.experiment;

import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.function.ToIntFunction;

/**
 * The results of all runs of a cell.
 *
 * @param runs one for each seed, in the order of the seeds
 */
public record CellResult(ExperimentCell cell, List<RunResult> runs) {

  public CellResult {
    runs = List.copyOf(runs);
  }

  /** A number of each run, in the order of the seeds. */
  public double[] each(ToDoubleFunction<RunResult> metric) {
    return runs.stream().mapToDouble(metric).toArray();
  }

  /** The mean of a number. */
  public Estimate mean(ToDoubleFunction<RunResult> metric) {
    return Estimate.mean(each(metric));
  }

  /** The sum of a count. */
  public int total(ToIntFunction<RunResult> metric) {
    return runs.stream().mapToInt(metric).sum();
  }

  /** The share of calls in which help arrived within the deadline. */
  public Estimate success() {
    return Estimate.share(total(RunResult::successes), total(RunResult::calls));
  }

  /** The paired difference to another cell, by seed. */
  public Estimate difference(CellResult other, ToDoubleFunction<RunResult> metric) {
    return Estimate.paired(each(metric), other.each(metric));
  }
}
