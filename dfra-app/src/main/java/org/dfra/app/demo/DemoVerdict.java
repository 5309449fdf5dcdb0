package org.dfra.app.demo;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.DoubleSupplier;
import java.util.stream.Collectors;
import org.dfra.app.measurement.MeasuredValue;
import org.dfra.app.measurement.RunMeasurements;

/**
 * Whether the measurements of a demonstration passed. Requirements always decide; timing targets
 * count only in strict mode, since times depend on the load of the computer.
 *
 * @param isStrict whether a missed time target is a failure too
 */
record DemoVerdict(RunMeasurements figures, boolean isStrict) {

  boolean passed() {
    return isStrict ? figures.missed().isEmpty() : figures.failedRequirements().isEmpty();
  }

  /**
   * The sentences below the measurements.
   *
   * @param pace current speed of this computer, as a fraction of the reference of the time targets;
   *     evaluated only if there are times
   */
  List<String> sentences(DoubleSupplier pace) {
    List<String> all = new ArrayList<>();
    if (figures.hasTimes()) {
      all.add(pace(pace.getAsDouble()));
    }
    List<MeasuredValue> late = figures.missedTimes();
    if (!late.isEmpty()) {
      String count =
          late.size() == 1 ? "1 time was MISSED: " : late.size() + " times were MISSED: ";
      String why =
          isStrict
              ? ". With --strict that is a failure."
              : ". Whether times are met depends on the computer, so this is no failure; with"
                  + " --strict it is one.";
      all.add(count + names(late) + why);
    }
    List<MeasuredValue> untrue = figures.failedRequirements();
    if (!untrue.isEmpty()) {
      all.add("FAILED: this must be true on every computer, and is not: " + names(untrue) + ".");
    }
    return all;
  }

  private static String pace(double share) {
    double load = ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
    return String.format(
        Locale.ROOT,
        "The times are for two processors with nothing else to do. This computer, with %d, can do"
            + " %.0f %% of that now%s.",
        Runtime.getRuntime().availableProcessors(),
        100 * share,
        load < 0 ? "" : String.format(Locale.ROOT, "; its load in the last minute was %.1f", load));
  }

  private static String names(List<MeasuredValue> figures) {
    return figures.stream().map(MeasuredValue::name).collect(Collectors.joining(", "));
  }
}
