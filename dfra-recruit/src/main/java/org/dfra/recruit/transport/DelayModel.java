package org.dfra.recruit.transport;

import java.util.Arrays;
import java.util.random.RandomGenerator;

/** Models the delay of messages. */
@FunctionalInterface
public interface DelayModel {

  /**
   * The delay of the next message, seconds, not negative.
   *
   * @param random source of random numbers
   */
  double next(RandomGenerator random);

  /** A constant delay. */
  static DelayModel constant(double seconds) {
    return random -> seconds;
  }

  /**
   * A shifted log-normal delay: a minimum plus a log-normally distributed excess.
   *
   * @param shortest minimum, seconds, not negative
   * @param median of the excess, seconds, above 0
   * @param sigma standard deviation of its natural logarithm, not negative
   */
  record LogNormalDelay(double shortest, double median, double sigma) implements DelayModel {

    private static final int HALVINGS = 60;

    public LogNormalDelay {
      if (!(shortest >= 0
          && median > 0
          && sigma >= 0
          && Double.isFinite(shortest + median + sigma))) {
        throw new IllegalArgumentException(
            "a delay needs finite numbers: a minimum of 0 s or more, a median above 0 s beyond it,"
                + " and a sigma of 0 or more, not "
                + shortest
                + " s, "
                + median
                + " s and "
                + sigma);
      }
    }

    /**
     * Fits the distribution: its minimum is the value at which the logarithms of the excess have
     * zero skewness; 0 where they are negatively skewed even then, and the smallest measured delay
     * where they are always positively skewed. The other two parameters are their mean and standard
     * deviation.
     *
     * @param delays measured, seconds; two different ones at least
     * @throws IllegalArgumentException if there are not
     */
    public static LogNormalDelay fit(double[] delays) {
      double least = Arrays.stream(delays).min().orElse(Double.NaN);
      double most = Arrays.stream(delays).max().orElse(Double.NaN);
      if (!(least >= 0 && most > least)) {
        throw new IllegalArgumentException(
            delays.length
                + " delays cannot be fitted: at least two must differ, and none may be negative");
      }
      double below = 0;
      double above = least;
      for (int i = 0; i < HALVINGS && skewness(delays, 0) > 0; i++) {
        double middle = (below + above) / 2;
        if (skewness(delays, middle) > 0) {
          below = middle;
        } else {
          above = middle;
        }
      }
      double[] logs = logs(delays, below);
      double mean = Arrays.stream(logs).average().orElseThrow();
      return new LogNormalDelay(below, Math.exp(mean), Math.sqrt(moment(logs, mean, 2)));
    }

    private static double skewness(double[] delays, double shortest) {
      double[] logs = logs(delays, shortest);
      double mean = Arrays.stream(logs).average().orElseThrow();
      return moment(logs, mean, 3);
    }

    private static double moment(double[] values, double mean, int power) {
      return Arrays.stream(values)
          .map(each -> Math.pow(each - mean, power))
          .average()
          .orElseThrow();
    }

    /** An excess of 0, that of the minimum, counts as a nanosecond. */
    private static double[] logs(double[] delays, double shortest) {
      return Arrays.stream(delays).map(each -> Math.log(Math.max(1e-9, each - shortest))).toArray();
    }

    /**
     * The delay at a number of standard deviations of the logarithm above the median, seconds; 0
     * gives the median, 1.2816 the 90th percentile, 2.3263 the 99th.
     */
    public double atDeviations(double deviations) {
      return shortest + median * Math.exp(sigma * deviations);
    }

    @Override
    public double next(RandomGenerator random) {
      return shortest + median * Math.exp(sigma * random.nextGaussian());
    }
  }
}
