package org.dfra.cli.event;

import java.util.ArrayDeque;
import java.util.Deque;

/** The most recent events: arrival times and sizes. Not thread-safe. */
final class EventWindow {

  private static final double NANOS = 1e9;

  /** An arrival; nanoseconds of a monotonic clock, and bytes. */
  private record Arrival(long nanos, long bytes) {}

  private final int width;
  private final Deque<Arrival> arrivals = new ArrayDeque<>();
  private long events;

  /**
   * @param width maximum number of events; further ones replace the oldest
   */
  EventWindow(int width) {
    this.width = width;
  }

  /** Adds an event. */
  void add(long nanos, long bytes) {
    events++;
    arrivals.addLast(new Arrival(nanos, bytes));
    if (arrivals.size() > width) {
      arrivals.removeFirst();
    }
  }

  /** Number of all events, including the replaced ones. */
  long totalCount() {
    return events;
  }

  /** Number of events in the window. */
  int size() {
    return arrivals.size();
  }

  /** Seconds from the first to the last event in the window. */
  private double span() {
    return arrivals.isEmpty()
        ? 0
        : (arrivals.getLast().nanos() - arrivals.getFirst().nanos()) / NANOS;
  }

  /** Events per second; NaN for fewer than two events. */
  double rate() {
    return size() < 2 ? Double.NaN : (size() - 1) / span();
  }

  /** Bytes per second, by mean size and rate; NaN for fewer than two events. */
  double bytesPerSecond() {
    return sizes().mean() * rate();
  }

  /** The intervals between consecutive events, in seconds. */
  SummaryStatistics intervals() {
    SummaryStatistics.RunningStatistics collector = new SummaryStatistics.RunningStatistics();
    Arrival last = null;
    for (Arrival each : arrivals) {
      if (last != null) {
        collector.add((each.nanos() - last.nanos()) / NANOS);
      }
      last = each;
    }
    return collector.spread();
  }

  /** The sizes, in bytes. */
  SummaryStatistics sizes() {
    SummaryStatistics.RunningStatistics collector = new SummaryStatistics.RunningStatistics();
    arrivals.forEach(each -> collector.add(each.bytes()));
    return collector.spread();
  }

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
}
