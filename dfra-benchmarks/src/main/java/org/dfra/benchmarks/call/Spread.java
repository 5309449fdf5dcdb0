package org.dfra.benchmarks.call;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;

/**
 * Lowest, median and highest of the repetitions' figures.
 *
 * @param low the lowest
 * @param median the median; of an even number of figures, the mean of the middle two
 * @param high the highest
 */
public record Spread(double low, double median, double high) {

  /**
   * Of these figures.
   *
   * @param values at least one
   */
  public static Spread of(List<Double> values) {
    List<Double> sorted = values.stream().sorted().toList();
    int middle = sorted.size() / 2;
    double median =
        sorted.size() % 2 == 1
            ? sorted.get(middle)
            : (sorted.get(middle - 1) + sorted.get(middle)) / 2;
    return new Spread(Collections.min(sorted), median, Collections.max(sorted));
  }

  /**
   * Of the ratios of figures of the same repetition.
   *
   * @param own as many as {@code reference}, at least one
   */
  public static Spread ofRatios(List<Double> own, List<Double> reference) {
    List<Double> ratios = new ArrayList<>();
    for (int i = 0; i < own.size(); i++) {
      ratios.add(own.get(i) / reference.get(i));
    }
    return of(ratios);
  }

  /** The median, and the other two in parentheses if they differ. */
  public String text() {
    return text(median) + (low < high ? " (" + text(low) + "–" + text(high) + ")" : "");
  }

  /** Three digits, as far as they are decimals. */
  public static String text(double value) {
    if (Double.isNaN(value)) {
      return "?";
    }
    int decimals = value >= 100 ? 0 : value >= 10 ? 1 : 2;
    return String.format(Locale.ROOT, "%." + decimals + "f", value);
  }
}
