package org.dfra.app.event;

import java.util.Locale;
import org.dfra.event.Delivery;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;

/** {@code ./dfra event hz}. */
@Command(
    name = "hz",
    description = "Measures how often a module tells something, readings unless --kind says else.",
    footer = {
      "",
      "Intervals are those at which events arrive here. A line each second, and one at",
      "the end: by --count, --for or Ctrl-C."
    })
final class HzCommand extends MeasurementCommand {

  /** Rates in hertz, intervals in seconds; null if there were too few events. */
  record RateReport(
      long events,
      int window,
      long lost,
      @Nullable Double rate,
      @Nullable Double minInterval,
      @Nullable Double maxInterval,
      @Nullable Double deviation) {}

  @Override
  long size(Delivery delivery) {
    return 0; // not measured
  }

  @Override
  Object value(EventWindow events, long lost) {
    SummaryStatistics intervals = events.intervals();
    return new RateReport(
        events.totalCount(),
        events.size(),
        lost,
        NumberFormats.orNull(events.rate()),
        NumberFormats.orNull(intervals.min()),
        NumberFormats.orNull(intervals.max()),
        NumberFormats.orNull(intervals.standardDeviation()));
  }

  @Override
  String inWords(EventWindow events) {
    SummaryStatistics intervals = events.intervals();
    return String.format(
        Locale.ROOT,
        "%s Hz; interval min %.4f s, max %.4f s, std %.4f s",
        NumberFormats.fourDigits(events.rate()),
        intervals.min(),
        intervals.max(),
        intervals.standardDeviation());
  }
}
