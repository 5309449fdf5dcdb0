package org.dfra.behaviors.fuzzy;

import java.math.BigDecimal;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.dfra.behaviors.fuzzy.FuzzySystem.Rule;
import org.dfra.behaviors.fuzzy.Variable.Term;

/** Formats rules as sentences: {@code left is close and centre is not away: tr is slow}. */
public final class RuleFormatter {

  private final FuzzySystem system;

  /** A formatter for a system's rules. */
  public RuleFormatter(FuzzySystem system) {
    this.system = system;
  }

  /** All of them, in their order. */
  public List<String> all() {
    return system.rules().stream().map(this::sentence).toList();
  }

  /** All of them, each with its number, from 1. */
  public List<String> numbered() {
    List<String> all = all();
    return IntStream.range(0, all.size()).mapToObj(i -> (i + 1) + ". " + all.get(i)).toList();
  }

  private String sentence(Rule rule) {
    boolean isAnd = rule.connective() == Rule.Connective.AND;
    String when = clauses(system.inputs(), rule.antecedents(), isAnd ? " and " : " or ");
    if (when.isEmpty()) {
      when = isAnd ? "always" : "never";
    }
    String then = clauses(system.outputs(), rule.consequents(), ", ");
    String weight = rule.weight() == 1 ? "" : " (weight " + plain(rule.weight()) + ")";
    return when + ": " + (then.isEmpty() ? "nothing" : then) + weight;
  }

  private static String plain(double weight) {
    return BigDecimal.valueOf(weight).stripTrailingZeros().toPlainString();
  }

  private static String clauses(List<Variable> variables, List<Integer> terms, String joined) {
    return IntStream.range(0, variables.size())
        .filter(i -> terms.get(i) != 0)
        .mapToObj(i -> variables.get(i).name() + " is " + termLabel(variables.get(i), terms.get(i)))
        .collect(Collectors.joining(joined));
  }

  /** A rule's condition on a variable; not for 0. */
  public static String termLabel(Variable variable, int term) {
    String word = termLabels(variable).get(Math.abs(term) - 1);
    return term < 0 ? "not " + word : word;
  }

  /** The names of a variable's terms; duplicate names with their number, from 1. */
  public static List<String> termLabels(Variable variable) {
    return distinctLabels(variable.terms().stream().map(Term::name).toList());
  }

  /** The same of their names. */
  public static List<String> distinctLabels(List<String> names) {
    return IntStream.range(0, names.size())
        .mapToObj(
            i ->
                Collections.frequency(names, names.get(i)) == 1
                    ? names.get(i)
                    : names.get(i) + " #" + (i + 1))
        .toList();
  }
}
