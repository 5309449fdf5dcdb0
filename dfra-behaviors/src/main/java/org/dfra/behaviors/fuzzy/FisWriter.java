package org.dfra.behaviors.fuzzy;

import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import org.dfra.behaviors.fuzzy.FuzzySystem.Rule;
import org.dfra.behaviors.fuzzy.Variable.Term;

/** Writes {@code .fis} files as MATLAB does; reading one gives an equal system. */
public final class FisWriter {

  private final StringBuilder text = new StringBuilder();

  private FisWriter() {}

  /**
   * Writes a file, replacing its content.
   *
   * @throws IOException if it cannot be written
   */
  public static void write(FuzzySystem system, Path file) throws IOException {
    Files.writeString(file, text(system));
  }

  /**
   * The text of a file.
   *
   * @throws IllegalArgumentException if a name contains a quote or a line break, which the format
   *     cannot represent
   */
  public static String text(FuzzySystem system) {
    FisWriter writer = new FisWriter();
    writer.system(system);
    writer.variables("Input", system.inputs());
    writer.variables("Output", system.outputs());
    writer.text.append("[Rules]\n");
    system.rules().forEach(writer::rule);
    return writer.text.toString();
  }

  private void system(FuzzySystem system) {
    text.append("[System]\n");
    entry("Name", quoted(system.name()));
    entry("Type", quoted(Operators.fisName(system.type())));
    entry("Version", "2.0");
    entry("NumInputs", system.inputs().size());
    entry("NumOutputs", system.outputs().size());
    entry("NumRules", system.rules().size());
    entry("AndMethod", quoted(Operators.fisName(system.operators().and())));
    entry("OrMethod", quoted(Operators.fisName(system.operators().or())));
    entry("ImpMethod", quoted(Operators.fisName(system.operators().implication())));
    entry("AggMethod", quoted(Operators.fisName(system.operators().aggregation())));
    entry("DefuzzMethod", quoted(Operators.fisName(system.operators().defuzzification())));
    text.append('\n');
  }

  private void variables(String what, List<Variable> variables) {
    for (int i = 0; i < variables.size(); i++) {
      Variable variable = variables.get(i);
      text.append('[').append(what).append(i + 1).append("]\n");
      entry("Name", quoted(variable.name()));
      entry("Range", "[" + number(variable.low()) + " " + number(variable.high()) + "]");
      entry("NumMFs", variable.terms().size());
      for (int j = 0; j < variable.terms().size(); j++) {
        Term term = variable.terms().get(j);
        entry(
            "MF" + (j + 1),
            quoted(term.name())
                + ":"
                + quoted(term.function().fisName())
                + ",["
                + term.function().parameters().stream()
                    .map(FisWriter::number)
                    .collect(Collectors.joining(" "))
                + "]");
      }
      text.append('\n');
    }
  }

  private void rule(Rule rule) {
    text.append(words(rule.antecedents()))
        .append(", ")
        .append(words(rule.consequents()))
        .append(" (")
        .append(number(rule.weight()))
        .append(") : ")
        .append(rule.connective() == Rule.Connective.AND ? 1 : 2)
        .append('\n');
  }

  private static String words(List<Integer> terms) {
    return terms.stream().map(String::valueOf).collect(Collectors.joining(" "));
  }

  private void entry(String key, Object value) {
    text.append(key).append('=').append(value).append('\n');
  }

  private static String quoted(String name) {
    if (name.indexOf('\'') >= 0 || name.indexOf('\n') >= 0 || name.indexOf('\r') >= 0) {
      throw new IllegalArgumentException(
          "the name "
              + name
              + " contains a quote or a line break, which a .fis file does not allow; rename it");
    }
    return "'" + name + "'";
  }

  /** The shortest text that parses to the same number; 10 rather than 10.0. */
  private static String number(double number) {
    BigDecimal exact = new BigDecimal(Double.toString(number)).stripTrailingZeros();
    return exact.scale() <= 0 && exact.precision() - exact.scale() <= 15
        ? exact.toPlainString()
        : exact.toString();
  }
}
