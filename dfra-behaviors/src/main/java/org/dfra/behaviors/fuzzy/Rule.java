package org.dfra.behaviors.fuzzy;

import java.util.List;

/**
 * A rule of a fuzzy system. Terms are named by their number, from 1; 0 stands for any, and a number
 * below zero for a term's opposite.
 *
 * @param antecedents a term of each input
 * @param consequents a term of each output; 0 leaves that output alone
 * @param weight how much the rule counts, from 0 to 1
 * @param connective how the antecedents are joined
 */
public record Rule(
    List<Integer> antecedents, List<Integer> consequents, double weight, Connective connective) {

  /** How antecedents are joined. */
  public enum Connective {
    /** All of them hold. */
    AND,
    /** One of them holds. */
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
