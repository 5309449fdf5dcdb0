package org.dfra.behaviors.fuzzy;

import java.math.BigDecimal;
import java.util.Arrays;
import org.dfra.behaviors.fuzzy.FisDocument.FisLine;

/** Parses numbers of {@code .fis} files; integers may have zero decimals. */
final class FisNumberParser {

  private FisNumberParser() {}

  /** Numbers separated by spaces or commas. */
  static double[] list(FisLine line, String text) {
    String stripped = text.strip();
    return stripped.isEmpty()
        ? new double[0]
        : Arrays.stream(stripped.split("[\\s,]+"))
            .mapToDouble(word -> number(line, word))
            .toArray();
  }

  static double number(FisLine line, String word) {
    if (word.matches("[-+]?Inf(inity)?")) {
      return word.startsWith("-") ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY;
    }
    try {
      // Not Double.parseDouble: it also accepts "0x1p3", "9f" and "NaN".
      return new BigDecimal(word).doubleValue();
    } catch (NumberFormatException e) {
      throw line.fault("\"" + word + "\" is not a number");
    }
  }

  static int integer(FisLine line, String text) {
    double number = number(line, text.strip());
    if (number != Math.rint(number) || Math.abs(number) > 1e6) {
      throw line.fault("\"" + text.strip() + "\" is not a whole number");
    }
    return (int) number;
  }
}
