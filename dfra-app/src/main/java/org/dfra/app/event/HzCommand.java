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
final class HzCommand extends Measurement {

  /** Rates in hertz, intervals in seconds; null where too few events came. */
  record Pace(
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
    Spread intervals = events.intervals();
    return new Pace(
        events.events(),
        events.size(),
        lost,
        Numbers.orNull(events.rate()),
        Numbers.orNull(intervals.min()),
        Numbers.orNull(intervals.max()),
        Numbers.orNull(intervals.deviation()));
  }

  @Override
  String inWords(EventWindow events) {
    Spread intervals = events.intervals();
    return String.format(
        Locale.ROOT,
        "%s Hz; interval min %.4f s, max %.4f s, std %.4f s",
        Numbers.fourDigits(events.rate()),
        intervals.min(),
        intervals.max(),
        intervals.deviation());
  }
}
