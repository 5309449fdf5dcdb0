package org.dfra.behaviors.fuzzy;

import java.util.List;
import org.dfra.behaviors.fuzzy.FuzzySystem.Rule;
import org.dfra.behaviors.fuzzy.Variable.Term;

/** The antecedents of a system's rules, stored for fast evaluation. */
final class RuleBase {

  private final MembershipFunction[] terms; // of all inputs, one after the other
  private final int[] inputOfTerm;
  private final double[] memberships; // of each term; then of each term's complement
  private final int[][] antecedents; // for each rule, indices in memberships
  private final boolean[] isOr;
  private final double[] weights;
  private final Operators.And and;
  private final Operators.Or or;
  private final double[] strengths;

  RuleBase(FuzzySystem system) {
    this.and = system.operators().and();
    this.or = system.operators().or();
    int count = system.inputs().stream().mapToInt(input -> input.terms().size()).sum();
    terms = new MembershipFunction[count];
    inputOfTerm = new int[count];
    memberships = new double[2 * count];
    int[] first = new int[system.inputs().size()];
    int next = 0;
    for (int input = 0; input < first.length; input++) {
      first[input] = next;
      for (Term term : system.inputs().get(input).terms()) {
        inputOfTerm[next] = input;
        terms[next++] = (MembershipFunction) term.function();
      }
    }
    List<Rule> rules = system.rules();
    antecedents = new int[rules.size()][];
    isOr = new boolean[rules.size()];
    weights = new double[rules.size()];
    strengths = new double[rules.size()];
    for (int i = 0; i < rules.size(); i++) {
      antecedents[i] = places(rules.get(i).antecedents(), first, count);
      isOr[i] = rules.get(i).connective() == Rule.Connective.OR;
      weights[i] = rules.get(i).weight();
    }
  }

  private static int[] places(List<Integer> named, int[] first, int complement) {
    int[] places = new int[(int) named.stream().filter(each -> each != 0).count()];
    int next = 0;
    for (int input = 0; input < first.length; input++) {
      int term = named.get(input);
      if (term != 0) {
        places[next++] = first[input] + Math.abs(term) - 1 + (term < 0 ? complement : 0);
      }
    }
    return places;
  }

  /** Firing strength of each rule. */
  double[] fire(double[] inputs) {
    for (int i = 0; i < terms.length; i++) {
      double membership = terms[i].at(inputs[inputOfTerm[i]]);
      memberships[i] = membership;
      memberships[terms.length + i] = 1 - membership;
    }
    for (int i = 0; i < antecedents.length; i++) {
      strengths[i] = weights[i] * (isOr[i] ? any(antecedents[i]) : all(antecedents[i]));
    }
    return strengths;
  }

  double[] strengths() {
    return strengths;
  }

  private double all(int[] places) {
    double strength = 1; // without a condition
    for (int i = 0; i < places.length && strength > 0; i++) { // cannot rise from 0
      strength = and.of(strength, memberships[places[i]]);
    }
    return strength;
  }

  private double any(int[] places) {
    double strength = 0;
    for (int place : places) {
      strength = or.of(strength, memberships[place]);
    }
    return strength;
  }
}
