package org.dfra.experiments.recruit.simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import java.util.function.ToIntFunction;
import org.dfra.experiments.recruit.simulation.Experiment.RunResult;
import org.dfra.recruit.transport.Transport.MessageMode;

/** The cells of the experiment. */
public final class ExperimentGrid {

  /** The strategies compared, and one in addition. */
  public static final List<String> STRATEGIES =
      List.of("affective", "greedy", "random", "contract-net");

  /** Ground vehicles. */
  public static final List<Integer> VEHICLES = List.of(3, 6, 12);

  /** Fractions of messages lost. */
  public static final List<Double> LOSSES = List.of(0.0, 0.10, 0.25, 0.50);

  private ExperimentGrid() {}

  /** The 72 cells, and 24 of the contract net in addition. */
  public static List<ExperimentCell> cells() {
    return cells(STRATEGIES);
  }

  /** 24 cells of each strategy. */
  public static List<ExperimentCell> cells(List<String> strategies) {
    List<ExperimentCell> cells = new ArrayList<>();
    for (String strategy : strategies) {
      for (MessageMode mode : MessageMode.values()) {
        for (int vehicles : VEHICLES) {
          for (double loss : LOSSES) {
            cells.add(new ExperimentCell(strategy, mode, vehicles, loss));
          }
        }
      }
    }
    return cells;
  }

  /** The strategies with results, in their order. */
  public static List<String> strategies(List<CellResult> results) {
    return results.stream().map(result -> result.cell().strategy()).distinct().toList();
  }

  /**
   * One combination of the varied parameters.
   *
   * @param strategy its name
   * @param mode transmission of messages to all
   * @param vehicles number of ground vehicles, two of which scan; there is one aircraft
   * @param loss fraction of messages lost, 0 to 1
   */
  public record ExperimentCell(String strategy, MessageMode mode, int vehicles, double loss) {

    public ExperimentCell {
      if (vehicles < 1 || !(loss >= 0 && loss <= 1)) {
        throw new IllegalArgumentException(
            vehicles
                + " vehicles at a loss of "
                + loss
                + " are invalid; give 1 vehicle or more, and a loss from 0 to 1");
      }
    }

    /** The same with another strategy. */
    public ExperimentCell with(String other) {
      return new ExperimentCell(other, mode, vehicles, loss);
    }

    /** {@code affective, broadcast, 6 vehicles, 10 % loss}. */
    @Override
    public String toString() {
      return String.format(
          Locale.ROOT,
          "%s, %s, %d vehicles, %.0f %% loss",
          strategy,
          mode.name().toLowerCase(Locale.ROOT),
          vehicles,
          100 * loss);
    }
  }

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
}
