package org.dfra.app.event;

/**
 * Summary of values; all components are NaN if there were none.
 *
 * @param mean their mean
 * @param min the minimum
 * @param max the maximum
 * @param standardDeviation their population standard deviation: divided by their number
 */
record SummaryStatistics(double mean, double min, double max, double standardDeviation) {

  /** Accumulates values by Welford's method, which is numerically stable. */
  static final class RunningStatistics {

    private long count;
    private double mean;
    private double squares;
    private double min = Double.POSITIVE_INFINITY;
    private double max = Double.NEGATIVE_INFINITY;

    void add(double value) {
      count++;
      double before = value - mean;
      mean += before / count;
      squares += before * (value - mean);
      min = Math.min(min, value);
      max = Math.max(max, value);
    }

    SummaryStatistics spread() {
      return count == 0
          ? new SummaryStatistics(Double.NaN, Double.NaN, Double.NaN, Double.NaN)
          : new SummaryStatistics(mean, min, max, Math.sqrt(squares / count));
    }
  }
}
