package org.dfra.report.measurement;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import org.dfra.report.plot.HtmlReport;
import org.junit.jupiter.api.Test;

/** A report begins with its result, its time and its targets. */
class ReportHeadTest {

  private static final Instant WHEN = Instant.parse("2026-11-23T08:00:00Z");

  /**
   * Asserts that the verdict, the date and the table of targets are the first of a report, in this
   * order.
   */
  private static void assertHead(String html) {
    assertThat(html)
        .containsPattern(
            "</h1>\\s*<p class=\"verdict (met|missed)\">[^<]+</p>"
                + "\\s*<p>\\d{4}-\\d\\d-\\d\\d \\d\\d:\\d\\d:\\d\\d\\sUTC</p>"
                + "\\s*<table>\\s*<thead><tr><th>Figure</th>(<th[^>]*>[^<]+</th>)*"
                + "<th[^>]*>Target</th><th>Result</th></tr>");
  }

  private static String head(MeasuredValue... figures) {
    RunMeasurements measured = new RunMeasurements();
    for (MeasuredValue each : figures) {
      measured.add(each);
    }
    HtmlReport html = new HtmlReport("A report");
    ReportHead.add(html, measured, WHEN);
    return html.heading("A section").html();
  }

  @Test
  void verdictDateAndTargetsStandFirst() {
    MeasuredValue met = new MeasuredValue("collisions", 0, 0, "");
    MeasuredValue late = new MeasuredValue("receiver back", 7.3, 5, "s");
    MeasuredValue untrue = new MeasuredValue("seconds in which two helped", 28, 0, "s");
    for (String each : new String[] {head(met), head(met, late), head(met, late, untrue)}) {
      assertHead(each);
      assertThat(each).contains("<p>2026-11-23 08:00:00");
    }
    assertThat(head(met)).contains("verdict met\">The target is met.<");
    assertThat(head(met, late))
        .contains("verdict met\">What must be true is true.", "MISSED: receiver back.<")
        .contains("<td>MISSED</td>");
    assertThat(head(met, late, untrue))
        .contains("verdict missed\">FAILED: seconds in which two helped.<");
  }
}
