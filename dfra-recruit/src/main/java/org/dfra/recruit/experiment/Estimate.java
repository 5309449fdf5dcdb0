package org.dfra.recruit.experiment;

import java.util.Arrays;
import java.util.Locale;
import org.apache.commons.statistics.interval.BinomialConfidenceInterval;
import org.apache.commons.statistics.interval.Interval;
import org.apache.commons.statistics.interval.NormalConfidenceInterval;

/**
 * A number that was measured several times, and how sure it is: 95 %.
 *
 * @param value measured
 * @param low lower end of the confidence interval
 * @param high upper end
 */
public record Estimate(double value, double low, double high) {

  private static final double ERROR = 0.05; // how often the interval misses

  /**
   * A mean, by Student's distribution. What is no number was not measured, and is left out.
   *
   * @return no numbers where fewer than two were measured
   */
  public static Estimate mean(double[] values) {
    double[] measured = Arrays.stream(values).filter(value -> !Double.isNaN(value)).toArray();
    int count = measured.length;
    double mean = Arrays.stream(measured).average().orElse(Double.NaN);
    if (count < 2) {
      return new Estimate(mean, Double.NaN, Double.NaN);
    }
    double squares = Arrays.stream(measured).map(value -> (value - mean) * (value - mean)).sum();
    return of(
        mean,
        NormalConfidenceInterval.MEAN.fromErrorRate(mean, squares / (count - 1), count, ERROR));
  }

  /** The mean of the differences of pairs: the first less the second. */
  public static Estimate paired(double[] first, double[] second) {
    if (first.length != second.length) {
      throw new IllegalArgumentException(
          first.length + " and " + second.length + " values are no pairs");
    }
    double[] differences = new double[first.length];
    Arrays.setAll(differences, i -> first[i] - second[i]);
    return mean(differences);
  }

  /** A share, by Wilson's score interval. */
  public static Estimate share(int successes, int trials) {
    return of(
        (double) successes / trials,
        BinomialConfidenceInterval.WILSON_SCORE.fromErrorRate(trials, successes, ERROR));
  }

  private static Estimate of(double value, Interval interval) {
    return new Estimate(value, interval.getLowerBound(), interval.getUpperBound());
  }

  /** {@code 7.70 (7.52 to 7.88)}. */
  @Override
  public String toString() {
    return String.format(Locale.ROOT, "%.2f (%.2f to %.2f)", value, low, high);
  }
}
