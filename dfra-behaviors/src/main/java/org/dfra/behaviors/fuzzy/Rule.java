package org.dfra.behaviors.fuzzy;

import java.util.List;

/**
 * A rule of a fuzzy system. Terms are numbered from 1; 0 means any, and a negative number the
 * complement (NOT) of a term.
 *
 * @param antecedents a term of each input
 * @param consequents a term of each output; 0 does not affect that output
 * @param weight weight of the rule, from 0 to 1
 * @param connective between the antecedents
 */
public record Rule(
    List<Integer> antecedents, List<Integer> consequents, double weight, Connective connective) {

  /** Connective between antecedents. */
  public enum Connective {
    /** Conjunction. */
    AND,
    /** Disjunction. */
    OR
  }

  public Rule {
    antecedents = List.copyOf(antecedents);
    consequents = List.copyOf(consequents);
    if (!(weight >= 0 && weight <= 1)) {
      throw new IllegalArgumentException("the weight " + weight + " is not from 0 to 1");
    }
  }
}
