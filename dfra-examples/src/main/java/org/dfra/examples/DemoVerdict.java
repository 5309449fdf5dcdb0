package org.dfra.examples;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.DoubleSupplier;
import java.util.stream.Collectors;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.report.measurement.RunMeasurements;

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
   * @param speed current speed of this computer, as a fraction of the reference of the time
   *     targets; evaluated only if there are times
   */
  List<String> sentences(DoubleSupplier speed) {
    List<String> all = new ArrayList<>();
    if (figures.hasTimes()) {
      all.add(speed(speed.getAsDouble()));
    }
    List<MeasuredValue> late = figures.missedTimes();
    if (!late.isEmpty()) {
      String count =
          late.size() == 1 ? "1 time was MISSED: " : late.size() + " times were MISSED: ";
      String why =
          isStrict
              ? ". With --strict this is a failure."
              : ". Times depend on the computer, so this is not a failure; with --strict it would be"
                  + " one.";
      all.add(count + names(late) + why);
    }
    List<MeasuredValue> untrue = figures.failedRequirements();
    if (!untrue.isEmpty()) {
      all.add(
          "FAILED, although it does not depend on the computer's speed: " + names(untrue) + ".");
    }
    return all;
  }

  private static String speed(double share) {
    double load = ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
    return String.format(
        Locale.ROOT,
        "The time bounds are for two idle processors. This computer, with %d, now has %.0f %% of"
            + " that speed%s.",
        Runtime.getRuntime().availableProcessors(),
        100 * share,
        load < 0 ? "" : String.format(Locale.ROOT, "; its load in the last minute was %.1f", load));
  }

  private static String names(List<MeasuredValue> figures) {
    return figures.stream().map(MeasuredValue::name).collect(Collectors.joining(", "));
  }
}
