package org.dfra.app.benchmark;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dfra.app.measurement.MeasuredValue;
import org.dfra.app.measurement.ReportHeadTest;
import org.dfra.app.measurement.RunMeasurements;
import org.junit.jupiter.api.Test;

/** The page of the benchmark, without the runs, which take minutes. */
class NavigationBenchTest {

  @Test
  void verdictDateAndTargetsStandFirstInTheReport() {
    RunMeasurements measured = new RunMeasurements();
    measured.add(new MeasuredValue("collisions", 0, 0, ""));
    String html =
        NavigationBench.page(3, measured, List.of(List.of("alone", "coverage", "0.99"))).html();
    ReportHeadTest.assertHead(html);
    assertThat(html)
        .contains("Searching by raster: 3 seeds", "<td>collisions</td>", "<td>coverage</td>");
  }
}
