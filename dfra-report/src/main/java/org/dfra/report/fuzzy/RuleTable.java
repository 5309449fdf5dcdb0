package org.dfra.report.fuzzy;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.dfra.behaviors.fuzzy.FuzzySystem;
import org.dfra.behaviors.fuzzy.FuzzySystem.Rule;
import org.dfra.behaviors.fuzzy.RuleFormatter;
import org.dfra.behaviors.fuzzy.Variable;
import org.dfra.report.plot.MatrixPanel;
import org.dfra.report.plot.MatrixPanel.Cell;
import org.dfra.report.plot.MatrixPanel.Factor;

/**
 * The rules of a system as a table of their consequents for each combination of the inputs' terms.
 * The table exists if each rule has full weight and requires terms, or any term, joined by AND, and
 * if the table is small enough to be readable.
 */
final class RuleTable {

  private static final int MOST_COLUMNS = 16;
  private static final int MOST_ROWS = 48;

  private final FuzzySystem system;
  private final List<Factor> rows;
  private final List<Factor> columns;

  private RuleTable(FuzzySystem system, List<Factor> rows, List<Factor> columns) {
    this.system = system;
    this.rows = rows;
    this.columns = columns;
  }

  /** The table, if there is one. */
  static Optional<RuleTable> of(FuzzySystem system) {
    boolean hasNoTerm = system.inputs().stream().anyMatch(input -> input.terms().isEmpty());
    if (hasNoTerm || !system.rules().stream().allMatch(RuleTable::isPlain)) {
      return Optional.empty();
    }
    List<Factor> factors = system.inputs().stream().map(RuleTable::factor).toList();
    for (int split = 1; split < factors.size(); split++) {
      List<Factor> rows = factors.subList(0, split);
      List<Factor> columns = factors.subList(split, factors.size());
      if (size(columns) <= MOST_COLUMNS && size(rows) <= MOST_ROWS) {
        return Optional.of(new RuleTable(system, rows, columns));
      }
    }
    return Optional.empty();
  }

  private static boolean isPlain(Rule rule) {
    return rule.weight() == 1
        && rule.antecedents().stream().allMatch(term -> term >= 0)
        && (rule.connective() == Rule.Connective.AND || asked(rule) == 1);
  }

  private static long asked(Rule rule) {
    return rule.antecedents().stream().filter(term -> term != 0).count();
  }

  private static Factor factor(Variable input) {
    return new Factor(input.name(), RuleFormatter.termLabels(input));
  }

  private static long size(List<Factor> factors) {
    return factors.stream().mapToLong(each -> each.values().size()).reduce(1, (a, b) -> a * b);
  }

  /** The rules' consequents for an output. */
  MatrixPanel panel(int output) {
    Variable variable = system.outputs().get(output);
    List<List<Cell>> cells = new ArrayList<>();
    for (int[] row : MatrixPanel.combinationsOf(rows)) {
      List<Cell> line = new ArrayList<>();
      for (int[] column : MatrixPanel.combinationsOf(columns)) {
        int[] terms = IntStream.concat(IntStream.of(row), IntStream.of(column)).toArray();
        line.add(cell(variable, seen(terms, output)));
      }
      cells.add(line);
    }
    return new MatrixPanel("What the rules say of " + variable.name(), rows, columns, cells);
  }

  /** The consequents of the rules that apply to these terms, given by their indices from 0. */
  private Set<Integer> seen(int[] terms, int output) {
    Set<Integer> seen = new LinkedHashSet<>();
    for (Rule rule : system.rules()) {
      int consequent = rule.consequents().get(output);
      boolean holds =
          asked(rule) == 0
              || IntStream.range(0, terms.length)
                  .allMatch(
                      i ->
                          rule.antecedents().get(i) == 0
                              || rule.antecedents().get(i) == terms[i] + 1);
      if (holds && consequent != 0) {
        seen.add(consequent);
      }
    }
    return seen;
  }

  private static Cell cell(Variable output, Set<Integer> seen) {
    if (seen.isEmpty()) {
      return Cell.EMPTY;
    }
    String text =
        String.join(
            " | ", seen.stream().map(term -> RuleFormatter.termLabel(output, term)).toList());
    boolean isOne = seen.size() == 1 && seen.iterator().next() > 0;
    int last = Math.max(1, output.terms().size() - 1);
    double part = isOne ? (seen.iterator().next() - 1.0) / last : Double.NaN;
    return new Cell(text, part, Surface.isAroundZero(output));
  }
}
