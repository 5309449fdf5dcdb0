package org.dfra.experiments.navigation;

import java.util.Arrays;
import java.util.Locale;
import java.util.Random;
import org.apache.commons.statistics.interval.BinomialConfidenceInterval;

/**
 * An estimate with its confidence interval of 95 %.
 *
 * @param value estimate
 * @param low lower end of the confidence interval
 * @param high upper end
 */
public record ConfidenceInterval(double value, double low, double high) {

  private static final double ERROR = 0.05; // error probability of the interval
  private static final int RESAMPLES = 2000;

  /** A proportion, by Wilson's score interval. */
  public static ConfidenceInterval ofProportion(int successes, int trials) {
    var wilson = BinomialConfidenceInterval.WILSON_SCORE.fromErrorRate(trials, successes, ERROR);
    return new ConfidenceInterval(
        (double) successes / trials, wilson.getLowerBound(), wilson.getUpperBound());
  }

  /** A mean, by the percentile bootstrap; deterministic for the same values. */
  public static ConfidenceInterval ofMean(double[] values) {
    double[] means = new double[RESAMPLES];
    Random random = new Random(values.length);
    for (int i = 0; i < RESAMPLES; i++) {
      double sum = 0;
      for (int j = 0; j < values.length; j++) {
        sum += values[random.nextInt(values.length)];
      }
      means[i] = sum / values.length;
    }
    Arrays.sort(means);
    return new ConfidenceInterval(
        Arrays.stream(values).average().orElse(Double.NaN),
        means[(int) (0.025 * RESAMPLES)],
        means[(int) (0.975 * RESAMPLES)]);
  }

  /** {@code 0.120 (0.118 to 0.123)}. */
  @Override
  public String toString() {
    return String.format(Locale.ROOT, "%.3f (%.3f to %.3f)", value, low, high);
  }
}
