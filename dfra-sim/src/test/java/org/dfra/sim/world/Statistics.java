package org.dfra.sim.world;

/** What the tests of noise compute from samples. */
public final class Statistics {

  private Statistics() {}

  public static double mean(double[] samples) {
    double sum = 0;
    for (double sample : samples) {
      sum += sample;
    }
    return sum / samples.length;
  }

  /** Standard deviation. */
  public static double sigma(double[] samples) {
    double mean = mean(samples);
    double sum = 0;
    for (double sample : samples) {
      sum += (sample - mean) * (sample - mean);
    }
    return Math.sqrt(sum / (samples.length - 1));
  }

  /** Correlation of the samples with those so many places later. */
  public static double correlation(double[] samples, int lag) {
    double mean = mean(samples);
    double own = 0;
    double with = 0;
    for (int i = 0; i + lag < samples.length; i++) {
      own += (samples[i] - mean) * (samples[i] - mean);
      with += (samples[i] - mean) * (samples[i + lag] - mean);
    }
    return with / own;
  }
}
