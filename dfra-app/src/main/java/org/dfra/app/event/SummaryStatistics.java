package org.dfra.app.event;

/**
 * How values lie; all are NaN where there was none.
 *
 * @param mean their mean
 * @param min the least
 * @param max the greatest
 * @param standardDeviation their standard deviation, of the values themselves: divided by their
 *     number
 */
record SummaryStatistics(double mean, double min, double max, double standardDeviation) {

  /** Takes values one after the other, by Welford's method: no sum of squares loses digits. */
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
