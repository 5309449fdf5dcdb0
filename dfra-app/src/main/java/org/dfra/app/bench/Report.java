package org.dfra.app.bench;

import java.io.IOException;
import java.io.PrintWriter;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** What a benchmark has measured, printed as it comes. */
final class Report {

  private final PrintWriter out;
  private final List<Figure> figures = new ArrayList<>();

  /**
   * One figure.
   *
   * @param most the most it should be; infinite where none is wanted
   */
  private record Figure(String what, double measured, double most, String unit) {}

  Report(PrintWriter out) {
    this.out = out;
  }

  /** Says what is being done. */
  void say(String sentence) {
    out.println(sentence);
    out.flush();
  }

  /** Notes a figure that is only stated. */
  void figure(String what, double measured, String unit) {
    figure(what, measured, Double.POSITIVE_INFINITY, unit);
  }

  /** Notes a figure that should be at most so much. */
  void figure(String what, double measured, double most, String unit) {
    figures.add(new Figure(what, measured, most, unit));
    String wanted =
        most == Double.POSITIVE_INFINITY
            ? ""
            : String.format(
                Locale.ROOT,
                "   wanted ≤ %.4g %s%s",
                most,
                unit,
                measured <= most ? "" : "   MISSED");
    out.printf(Locale.ROOT, "  %-62s %9.4g %-4s%s%n", what, measured, unit, wanted);
    out.flush();
  }

  /** Whether every figure is what it should be. */
  boolean isMet() {
    return figures.stream().allMatch(each -> each.measured() <= each.most());
  }

  /** Appends the figures to a CSV file, which is begun with a header where it does not exist. */
  void append(Path file, String bench) throws IOException {
    StringBuilder rows = new StringBuilder();
    if (!Files.exists(file)) {
      rows.append("when,bench,java,cores,load,figure,measured,wanted_at_most,unit\n");
    }
    double load = ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
    Instant now = Instant.now().truncatedTo(ChronoUnit.SECONDS);
    for (Figure each : figures) {
      rows.append(
          String.format(
              Locale.ROOT,
              "%s,%s,%s,%d,%.1f,\"%s\",%.6g,%s,%s%n",
              now,
              bench,
              Runtime.version().feature(),
              Runtime.getRuntime().availableProcessors(),
              load,
              each.what(),
              each.measured(),
              each.most() == Double.POSITIVE_INFINITY
                  ? ""
                  : String.format(Locale.ROOT, "%.6g", each.most()),
              each.unit()));
    }
    Files.writeString(file, rows, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
  }

  /** The value that this part of all values does not exceed; 0.5 gives the median. */
  static double quantile(double[] values, double part) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    return sorted[Math.min(sorted.length - 1, (int) (part * sorted.length))];
  }
}
