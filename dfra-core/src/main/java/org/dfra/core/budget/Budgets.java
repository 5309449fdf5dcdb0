package org.dfra.core.budget;

import java.util.List;
import java.util.Optional;

/**
 * The budgets that a policy declares. Immutable.
 *
 * @param all in their order; each that is about a call counts it
 * @param radios in their order; the first that is about a robot counts
 */
public record Budgets(List<Budget> all, List<RadioLimit> radios) {

  /** No budgets. */
  public static final Budgets NONE = new Budgets(List.of(), List.of());

  /** Copies the lists. */
  public Budgets {
    all = List.copyOf(all);
    radios = List.copyOf(radios);
  }

  /** What the network of a robot carries, in bytes per second; empty if nothing is declared. */
  public Optional<Double> radio(String robot) {
    return radios.stream()
        .filter(each -> each.robots().test(robot))
        .map(RadioLimit::bytesPerSecond)
        .findFirst();
  }
}
