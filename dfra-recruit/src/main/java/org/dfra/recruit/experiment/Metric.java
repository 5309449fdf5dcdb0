package org.dfra.recruit.experiment;

import java.util.function.ToDoubleFunction;

/** What is measured of a run; of every one less is better. */
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

  /** Such as {@code time to the choice}. */
  public String title() {
    return title;
  }

  /** Its unit, or what it is counted by. */
  public String unit() {
    return unit;
  }

  /** Of one run; NaN where there is nothing to measure. */
  public double of(RunResult run) {
    return value.applyAsDouble(run);
  }

  /** Over all runs of a cell: a share by Wilson's interval, all else by Student's. */
  public Estimate of(CellResult result) {
    return result.mean(value);
  }

  /** How much more there is here than there; the runs of a seed are pairs. */
  public Estimate difference(CellResult here, CellResult there) {
    return here.difference(there, value);
  }

  private static double failures(RunResult run) {
    return 100.0 * (run.calls() - run.successes()) / run.calls();
  }
}
