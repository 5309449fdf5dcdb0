package org.dfra.report.measurement;

import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.dfra.report.plot.HtmlReport;

/** The head of every report: the verdict, the date, and the targets. */
public final class ReportHead {

  private static final DateTimeFormatter DATE =
      DateTimeFormatter.ofPattern("uuuu-MM-dd HH:mm:ss 'UTC'", Locale.ROOT)
          .withZone(ZoneOffset.UTC);

  private ReportHead() {}

  /**
   * Adds it to an empty report.
   *
   * @param figures the measurements; those without a target are in the table too
   */
  public static void add(HtmlReport html, RunMeasurements figures, Instant when) {
    html.verdict(figures.failedRequirements().isEmpty(), verdict(figures));
    html.paragraph(date(when));
    if (!figures.all().isEmpty()) {
      html.table(
          List.of("Figure", "Measured", "Target", "Result"),
          figures.all().stream()
              .map(each -> List.of(each.name(), each.valueText(), each.targetText(), result(each)))
              .toList());
    }
  }

  /** A date and time as in reports. */
  public static String date(Instant when) {
    return DATE.format(when);
  }

  private static String result(MeasuredValue figure) {
    return figure.targetText().isEmpty() ? "" : figure.isMet() ? "met" : "MISSED";
  }

  private static String verdict(RunMeasurements figures) {
    long targets = figures.all().stream().filter(each -> !each.targetText().isEmpty()).count();
    if (!figures.failedRequirements().isEmpty()) {
      return "FAILED: " + names(figures.failedRequirements());
    } else if (!figures.missedTimes().isEmpty()) {
      return "What must be true is true. Times that depend on the computer are MISSED: "
          + names(figures.missedTimes());
    }
    return targets == 1 ? "The target is met." : "All " + targets + " targets are met.";
  }

  private static String names(List<MeasuredValue> figures) {
    return figures.stream().map(MeasuredValue::name).collect(Collectors.joining(", ")) + ".";
  }
}
