package org.dfra.benchmarks;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.report.measurement.RunMeasurements;
import org.junit.jupiter.api.Test;

/** The page of the benchmark, without the runs, which take minutes. */
class NavigationBenchTest {

  /** Verdict, date and targets are the first of a report. */
  private static final String REPORT_HEAD =
      "</h1>\\s*<p class=\"verdict (met|missed)\">[^<]+</p>"
          + "\\s*<p>[-\\d]+ [:\\d]+\\sUTC</p>\\s*<table>";

  @Test
  void verdictDateAndTargetsStandFirstInTheReport() {
    RunMeasurements measured = new RunMeasurements();
    measured.add(new MeasuredValue("collisions", 0, 0, ""));
    String html =
        NavigationBench.page(3, measured, List.of(List.of("alone", "coverage", "0.99"))).html();
    assertThat(html).containsPattern(REPORT_HEAD);
    assertThat(html)
        .contains("Searching by raster: 3 seeds", "<td>collisions</td>", "<td>coverage</td>");
  }
}
