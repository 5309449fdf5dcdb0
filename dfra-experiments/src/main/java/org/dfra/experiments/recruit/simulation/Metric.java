package org.dfra.experiments.recruit.simulation;

import java.util.function.ToDoubleFunction;
import org.dfra.experiments.recruit.simulation.Experiment.RunResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.CellResult;

/** A metric of a run; lower is better for all. */
public enum Metric {
  TRANSMISSIONS("transmissions", "each", RunResult::transmissionsEach),
  RECEPTIONS("transmissions, broadcast as n", "each", RunResult::receptionsEach),
  ALLOCATION("time to the choice", "s", RunResult::allocation),
  ARRIVAL("time to the arrival", "s", RunResult::arrival),
  FAILURES("calls without help in time", "%", Metric::failures) {
    @Override
    public Estimate of(CellResult result) {
      Estimate success = result.success();
      return new Estimate(
          100 * (1 - success.value()), 100 * (1 - success.high()), 100 * (1 - success.low()));
    }
  },
  DUPLICATE_HELPERS("second helpers", "in a run", RunResult::duplicateHelpers),
  ORPHANED_HELPERS("orphaned helpers", "in a run", RunResult::orphanedHelpers),
  REGRET("ETA regret", "s", RunResult::regret),
  RASTER_TIME_LOST("raster time lost", "s", RunResult::rasterTimeLost),
  TRAVEL("travel of a vehicle", "m", RunResult::travel);

  private final String title;
  private final String unit;
  private final ToDoubleFunction<RunResult> value;

  Metric(String title, String unit, ToDoubleFunction<RunResult> value) {
    this.title = title;
    this.unit = unit;
    this.value = value;
  }

  /** Its name, such as {@code time to the choice}. */
  public String title() {
    return title;
  }

  /** Its unit, or the counted item. */
  public String unit() {
    return unit;
  }

  /** Its value in one run; NaN where it is undefined. */
  public double of(RunResult run) {
    return value.applyAsDouble(run);
  }

  /**
   * Its estimate over all runs of a cell: a proportion by Wilson's interval, others by Student's.
   */
  public Estimate of(CellResult result) {
    return result.mean(value);
  }

  /** The paired difference between two cells, by seed. */
  public Estimate difference(CellResult here, CellResult there) {
    return here.difference(there, value);
  }

  private static double failures(RunResult run) {
    return 100.0 * (run.calls() - run.successes()) / run.calls();
  }
}
