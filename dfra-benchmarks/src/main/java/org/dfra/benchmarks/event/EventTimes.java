package org.dfra.benchmarks.event;

import java.util.Arrays;

/**
 * Latencies of all events to all listeners in one repetition, from the source to the listener's
 * code.
 *
 * @param p50 median, milliseconds
 * @param p99 99th percentile, milliseconds
 * @param longest the longest, milliseconds
 * @param cpu processor time of all processes for a delivery, microseconds, also that of their
 *     compilers and garbage collectors
 * @param lost events that did not arrive at a listener; their latencies are not counted
 */
public record EventTimes(double p50, double p99, double longest, double cpu, int lost) {

  private static final double NANOS_PER_MILLI = 1e6;

  /**
   * @param nanos each latency, nanoseconds; at least one
   * @param cpu as above
   * @param lost as above
   */
  static EventTimes of(long[] nanos, double cpu, int lost) {
    long[] sorted = nanos.clone();
    Arrays.sort(sorted);
    return new EventTimes(
        quantile(sorted, 0.5), quantile(sorted, 0.99), quantile(sorted, 1), cpu, lost);
  }

  private static double quantile(long[] sorted, double part) {
    return sorted[Math.min(sorted.length - 1, (int) (part * sorted.length))] / NANOS_PER_MILLI;
  }
}
