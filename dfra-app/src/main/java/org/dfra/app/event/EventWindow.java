package org.dfra.app.event;

import java.util.ArrayDeque;
import java.util.Deque;

/** The last events that came: when, and how large. Not safe for several threads by itself. */
final class EventWindow {

  private static final double NANOS = 1e9;

  /** An arrival; nanoseconds of a clock that nobody sets, and bytes. */
  private record Arrival(long nanos, long bytes) {}

  private final int width;
  private final Deque<Arrival> arrivals = new ArrayDeque<>();
  private long events;

  /**
   * @param width how many events it holds; more push the oldest out
   */
  EventWindow(int width) {
    this.width = width;
  }

  /** An event came. */
  void add(long nanos, long bytes) {
    events++;
    arrivals.addLast(new Arrival(nanos, bytes));
    if (arrivals.size() > width) {
      arrivals.removeFirst();
    }
  }

  /** All events that came, also those that have been pushed out. */
  long totalCount() {
    return events;
  }

  /** Events that it holds. */
  int size() {
    return arrivals.size();
  }

  /** Seconds from the first to the last event that it holds. */
  private double span() {
    return arrivals.isEmpty()
        ? 0
        : (arrivals.getLast().nanos() - arrivals.getFirst().nanos()) / NANOS;
  }

  /** Events per second; NaN where fewer than two came. */
  double rate() {
    return size() < 2 ? Double.NaN : (size() - 1) / span();
  }

  /** Bytes per second, by mean size and rate; NaN where fewer than two events came. */
  double bytesPerSecond() {
    return sizes().mean() * rate();
  }

  /** The intervals between one event and the next, in seconds. */
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
}
