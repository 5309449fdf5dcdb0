package org.dfra.app.figure;

import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.dfra.app.plot.HtmlReport;

/** What stands first in every report: how it went, when that was, and what was wanted. */
public final class ReportHead {

  private static final DateTimeFormatter DATE =
      DateTimeFormatter.ofPattern("uuuu-MM-dd HH:mm:ss 'UTC'", Locale.ROOT)
          .withZone(ZoneOffset.UTC);

  private ReportHead() {}

  /**
   * Adds it to a report that has nothing yet.
   *
   * @param figures what was measured; those that are only stated are in the table too
   */
  public static void add(HtmlReport html, Figures figures, Instant when) {
    html.verdict(figures.untrue().isEmpty(), verdict(figures));
    html.paragraph(date(when));
    if (!figures.all().isEmpty()) {
      html.table(
          List.of("Figure", "Measured", "Target", "Result"),
          figures.all().stream()
              .map(each -> List.of(each.what(), each.value(), each.target(), result(each)))
              .toList());
    }
  }

  /** A moment as reports tell it. */
  public static String date(Instant when) {
    return DATE.format(when);
  }

  private static String result(Figure figure) {
    return figure.target().isEmpty() ? "" : figure.isMet() ? "met" : "MISSED";
  }

  private static String verdict(Figures figures) {
    long targets = figures.all().stream().filter(each -> !each.target().isEmpty()).count();
    if (!figures.untrue().isEmpty()) {
      return "FAILED: " + names(figures.untrue());
    } else if (!figures.late().isEmpty()) {
      return "What must be true is true. Times that depend on the computer are MISSED: "
          + names(figures.late());
    }
    return targets == 1 ? "The target is met." : "All " + targets + " targets are met.";
  }

  private static String names(List<Figure> figures) {
    return figures.stream().map(Figure::what).collect(Collectors.joining(", ")) + ".";
  }
}
