package org.dfra.behaviors.fuzzy;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import org.dfra.behaviors.fuzzy.Operators.Aggregation;
import org.dfra.behaviors.fuzzy.Operators.Implication;

/** The consequents of one output, each sampled once on the output's grid. */
final class OutputAggregator {

  /** Points of the grid, both ends of the range included. */
  static final int POINTS = 101;

  private final double[] grid = new double[POINTS];
  private final double[] aggregate = new double[POINTS];
  private final double[][] sets; // the distinct consequents
  private final int[] setOfRule; // −1 for none
  private final double[] strongest; // for each set, among its rules
  private final Implication implication;
  private final Aggregation aggregation;
  private final double middle;

  OutputAggregator(FuzzySystem system, int output) {
    Variable variable = system.outputs().get(output);
    implication = system.operators().implication();
    aggregation = system.operators().aggregation();
    middle = variable.middle();
    for (int i = 0; i < POINTS; i++) {
      grid[i] = variable.low() + i * (variable.high() - variable.low()) / (POINTS - 1);
    }
    setOfRule = new int[system.rules().size()];
    Map<Integer, Integer> places = new LinkedHashMap<>();
    for (int rule = 0; rule < setOfRule.length; rule++) {
      int term = system.rules().get(rule).consequents().get(output);
      setOfRule[rule] = term == 0 ? -1 : places.computeIfAbsent(term, key -> places.size());
    }
    sets = new double[places.size()][];
    places.forEach((term, place) -> sets[place] = sampled(variable, term));
    strongest = new double[sets.length];
  }

  private double[] sampled(Variable variable, int term) {
    MembershipFunction membership =
        (MembershipFunction) variable.terms().get(Math.abs(term) - 1).function();
    return Arrays.stream(grid)
        .map(x -> term < 0 ? 1 - membership.at(x) : membership.at(x))
        .toArray();
  }

  double[] grid() {
    return grid;
  }

  double middle() {
    return middle;
  }

  /** The aggregated sets of all rules, on the grid. */
  double[] aggregate(double[] strengths) {
    Arrays.fill(aggregate, 0);
    if (aggregation == Aggregation.MAX) {
      // Both implications grow with the strength, so of each set only its strongest rule matters.
      Arrays.fill(strongest, 0);
      for (int rule = 0; rule < strengths.length; rule++) {
        int set = setOfRule[rule];
        if (set >= 0 && strengths[rule] > strongest[set]) {
          strongest[set] = strengths[rule];
        }
      }
      for (int set = 0; set < sets.length; set++) {
        if (strongest[set] > 0) {
          highest(strongest[set], sets[set]);
        }
      }
    } else {
      for (int rule = 0; rule < strengths.length; rule++) {
        if (setOfRule[rule] >= 0) {
          add(strengths[rule], sets[setOfRule[rule]]);
        }
      }
    }
    return aggregate;
  }

  private void highest(double strength, double[] set) {
    boolean isCut = implication == Implication.MIN;
    for (int i = 0; i < POINTS; i++) {
      double implied = isCut ? (strength < set[i] ? strength : set[i]) : strength * set[i];
      if (implied > aggregate[i]) {
        aggregate[i] = implied;
      }
    }
  }

  private void add(double strength, double[] set) {
    for (int i = 0; i < POINTS; i++) {
      aggregate[i] = aggregation.of(aggregate[i], implication.of(strength, set[i]));
    }
  }
}
