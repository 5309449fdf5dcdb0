package org.dfra.recruit.experiment;

import java.util.ArrayList;
import java.util.List;
import org.dfra.recruit.transport.MessageMode;

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
}
