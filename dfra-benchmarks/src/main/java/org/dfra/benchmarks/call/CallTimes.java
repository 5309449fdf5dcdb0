package org.dfra.benchmarks.call;

import java.util.Arrays;

/**
 * The duration of a number of calls, all of which gave the right answer.
 *
 * @param calls number of calls
 * @param p50 median duration of a call, microseconds
 * @param p99 99th percentile of that, microseconds
 * @param perSecond calls per second, of all threads together
 */
public record CallTimes(int calls, double p50, double p99, double perSecond) {

  private static final double NANOS_PER_MICRO = 1e3;
  private static final double NANOS_PER_SECOND = 1e9;

  /**
   * @param nanos duration of each call, nanoseconds
   * @param elapsed how long calls were made, nanoseconds
   */
  static CallTimes of(long[] nanos, long elapsed) {
    long[] sorted = nanos.clone();
    Arrays.sort(sorted);
    return new CallTimes(
        nanos.length,
        quantile(sorted, 0.5),
        quantile(sorted, 0.99),
        nanos.length * NANOS_PER_SECOND / elapsed);
  }

  private static double quantile(long[] sorted, double part) {
    return sorted[Math.min(sorted.length - 1, (int) (part * sorted.length))] / NANOS_PER_MICRO;
  }

  /** In one line. */
  String line() {
    return calls + " " + p50 + " " + p99 + " " + perSecond;
  }

  /** Reads {@link #line}. */
  static CallTimes parse(String line) {
    String[] words = line.split(" ", -1);
    return new CallTimes(
        Integer.parseInt(words[0]),
        Double.parseDouble(words[1]),
        Double.parseDouble(words[2]),
        Double.parseDouble(words[3]));
  }
}
