package org.dfra.report.fuzzy;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import org.dfra.behaviors.fuzzy.FuzzySystem;
import org.dfra.behaviors.fuzzy.Operators;
import org.dfra.behaviors.fuzzy.RuleFormatter;
import org.dfra.behaviors.fuzzy.Variable;
import org.dfra.behaviors.fuzzy.Variable.Term;
import org.dfra.report.plot.Numerals;
import org.dfra.report.terminal.Table;
import org.dfra.report.terminal.Terminal;

/**
 * A fuzzy system in the command's output.
 *
 * @param name its name
 * @param type mamdani or sugeno
 * @param operators its inference operators
 * @param inputs its inputs
 * @param outputs its outputs
 * @param rules sentences, in their order
 * @param surfaces descriptions of the surfaces in the image
 * @param image the image file
 */
record SystemView(
    String name,
    String type,
    OperatorsView operators,
    List<VariableView> inputs,
    List<VariableView> outputs,
    List<String> rules,
    List<String> surfaces,
    String image) {

  /** Up to this number, rules are printed; more are only counted. */
  private static final int MOST_RULES = 12;

  /** The operators by their names in a {@code .fis} file. */
  record OperatorsView(
      String and, String or, String implication, String aggregation, String defuzzification) {

    static OperatorsView of(Operators methods) {
      return new OperatorsView(
          word(methods.and()),
          word(methods.or()),
          word(methods.implication()),
          word(methods.aggregation()),
          word(methods.defuzzification()));
    }

    /** Without those that a Sugeno system does not use. */
    String words(boolean isMamdani) {
      String sets = ", implication " + implication + ", aggregation " + aggregation;
      return "and " + and + ", or " + or + (isMamdani ? sets : "") + ", " + defuzzification;
    }
  }

  /** An input or output; the ends of its range are in its own unit. */
  record VariableView(String name, double low, double high, List<TermView> terms) {

    static VariableView of(Variable variable) {
      return new VariableView(
          variable.name(),
          variable.low(),
          variable.high(),
          variable.terms().stream().map(TermView::of).toList());
    }

    String range() {
      return Numerals.of(low) + " to " + Numerals.of(high);
    }

    String words() {
      return String.join(
          ", ", RuleFormatter.distinctLabels(terms.stream().map(TermView::name).toList()));
    }
  }

  /** A term, with its type and parameters as in a {@code .fis} file. */
  record TermView(String name, String type, List<Double> parameters) {

    static TermView of(Term term) {
      return new TermView(term.name(), term.function().fisName(), term.function().parameters());
    }
  }

  static SystemView of(FuzzySystem system, List<Surface> surfaces, Path picture) {
    return new SystemView(
        system.name(),
        word(system.type()),
        OperatorsView.of(system.operators()),
        system.inputs().stream().map(VariableView::of).toList(),
        system.outputs().stream().map(VariableView::of).toList(),
        new RuleFormatter(system).all(),
        surfaces.stream().map(Surface::description).toList(),
        picture.toString());
  }

  private boolean isMamdani() {
    return type.equals(word(FuzzySystem.Type.MAMDANI));
  }

  private static String word(Enum<?> method) {
    return method.name().toLowerCase(Locale.ROOT);
  }

  /** Lines of text output. */
  List<String> lines() {
    List<String> lines = new ArrayList<>();
    lines.add(
        name + ": " + (isMamdani() ? "Mamdani" : "Sugeno") + ", " + operators.words(isMamdani()));
    lines.add("");
    Table table = new Table("VARIABLE", "ROLE", "RANGE", "TERMS");
    inputs.forEach(each -> table.row(each.name(), "input", each.range(), each.words()));
    outputs.forEach(each -> table.row(each.name(), "output", each.range(), each.words()));
    lines.addAll(table.lines(Terminal.columns()));
    lines.add("");
    if (rules.size() <= MOST_RULES) {
      IntStream.range(0, rules.size())
          .forEach(i -> lines.add("  " + (i + 1) + ". " + rules.get(i)));
    } else {
      lines.add(rules.size() + " rules, which are in the picture.");
    }
    lines.add("");
    lines.add("Drawn: " + image);
    return lines;
  }
}
