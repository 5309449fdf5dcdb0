package org.dfra.experiments.recruit.simulation;

import java.util.Arrays;
import java.util.Locale;
import org.apache.commons.statistics.interval.BinomialConfidenceInterval;
import org.apache.commons.statistics.interval.Interval;
import org.apache.commons.statistics.interval.NormalConfidenceInterval;

/**
 * The estimate of a repeatedly measured number, with its 95 % confidence interval.
 *
 * @param value estimated
 * @param low lower end of the confidence interval
 * @param high upper end
 */
public record Estimate(double value, double low, double high) {

  private static final double ERROR = 0.05; // error probability of the interval

  /**
   * A mean, by Student's distribution. NaN values are dropped as not measured.
   *
   * @return NaN where fewer than two were measured
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

  /** The mean of paired differences: the first minus the second. */
  public static Estimate paired(double[] first, double[] second) {
    if (first.length != second.length) {
      throw new IllegalArgumentException(
          first.length + " and " + second.length + " values cannot be paired");
    }
    double[] differences = new double[first.length];
    Arrays.setAll(differences, i -> first[i] - second[i]);
    return mean(differences);
  }

  /** A proportion, by Wilson's score interval. */
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
