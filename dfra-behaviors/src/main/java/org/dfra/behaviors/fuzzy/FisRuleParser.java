package org.dfra.behaviors.fuzzy;

import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.behaviors.fuzzy.FisDocument.FisLine;

/** Reads the rules of a {@code .fis} file, {@code 1 -2, 3 (1) : 1} each. */
final class FisRuleParser {

  private static final Pattern RULE =
      Pattern.compile("([^,]+),([^(]*)\\(([^)]*)\\)\\s*:\\s*(\\S+)");

  private final int inputs;
  private final int outputs;

  FisRuleParser(int inputs, int outputs) {
    this.inputs = inputs;
    this.outputs = outputs;
  }

  Rule rule(FisLine line) {
    Matcher parts = RULE.matcher(line.value());
    if (!parts.matches()) {
      throw line.fault(
          "\"" + line.value() + "\" is no rule; write terms, terms (weight) : 1 for and, 2 for or");
    }
    List<Integer> antecedents = terms(line, parts.group(1), inputs, "inputs");
    List<Integer> consequents = terms(line, parts.group(2), outputs, "outputs");
    double weight = FisNumberParser.number(line, parts.group(3).strip());
    int connective = FisNumberParser.integer(line, parts.group(4));
    if (connective != 1 && connective != 2) {
      throw line.fault(
          "the connective \"" + parts.group(4) + "\" is neither 1 for and nor 2 for or");
    }
    try {
      return new Rule(
          antecedents,
          consequents,
          weight,
          connective == 1 ? Rule.Connective.AND : Rule.Connective.OR);
    } catch (IllegalArgumentException e) {
      throw line.fault(String.valueOf(e.getMessage()));
    }
  }

  private static List<Integer> terms(FisLine line, String text, int wanted, String what) {
    List<Integer> terms =
        Arrays.stream(text.strip().split("\\s+"))
            .filter(word -> !word.isEmpty())
            .map(word -> FisNumberParser.integer(line, word))
            .toList();
    if (terms.size() != wanted) {
      throw line.fault(
          "the rule \""
              + line.value()
              + "\" names terms of "
              + terms.size()
              + " "
              + what
              + "; the system has "
              + wanted);
    }
    return terms;
  }
}
