package org.dfra.examples.raster;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.dfra.report.progress.ProgressReporter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A short search in lock-step, and its report. */
class RasterReportTest {

  /** Verdict, date and targets are the first of a report. */
  private static final String REPORT_HEAD =
      "</h1>\\s*<p class=\"verdict (met|missed)\">[^<]+</p>"
          + "\\s*<p>[-\\d]+ [:\\d]+\\sUTC</p>\\s*<table>";

  private static final List<String> FIGURES =
      List.of(
          "paths.svg",
          "estimates.svg",
          "coverage.svg",
          "clearance.svg",
          "cross-track.svg",
          "fuzzy.svg",
          "metrics.svg");

  /** 9 m by 8 m in the middle of the field, with a post in it. */
  private static final String REGION =
      "48.000103,11.000215 48.000103,11.000335 48.000175,11.000335 48.000175,11.000215";

  @TempDir Path folder;

  private final StringWriter reported = new StringWriter();

  private void search(long seed, Path report) {
    RasterOptions options = new RasterOptions();
    options.local = true;
    options.region = REGION;
    options.spacing = 2.5;
    options.seed = seed;
    ProgressReporter progress =
        new ProgressReporter(new PrintWriter(reported, true), System::nanoTime);
    assertThat(RasterDemo.of(progress, options, report).run()).as(reported.toString()).isTrue();
  }

  @Test
  void isWrittenWholeAndTheSameSeedGivesTheSameBytes() throws Exception {
    search(3, folder.resolve("one"));
    search(3, folder.resolve("other"));
    Map<String, String> one = files(folder.resolve("one"), ".csv");
    assertThat(one)
        .containsKeys("metrics.csv", "events.csv", "collisions.csv")
        .containsKeys(
            "atrv1-path.csv", "atrv1-advice.csv", "atrv1-clearance.csv", "atrv1-fixes.csv")
        .containsKeys("atrv2-path.csv", "atrv2-cross-track.csv", "atrv2-waypoints.csv")
        .isEqualTo(files(folder.resolve("other"), ".csv"));
    assertThat(one.get("atrv1-path.csv").lines()).hasSizeGreaterThan(300);
    assertThat(one.get("atrv1-fixes.csv")).contains(",gps_front,", ",gps_rear,");
    assertThat(one.get("atrv2-advice.csv").lines()).hasSizeGreaterThan(300);
    assertThat(one.get("atrv1-teammates.csv").lines())
        .hasSizeGreaterThan(100)
        .element(50)
        .asString()
        .contains(",atrv2,");
    assertThat(one.get("metrics.csv").lines().skip(1))
        .hasSize(2)
        .allSatisfy(row -> assertThat(row).contains(",true,", "it has reached all waypoints"));
    assertThat(reported.toString().replaceAll("\\s+", " "))
        .contains("Mode local:", "Planning lanes in the region", "atrv2: the region is searched");

    String html = Files.readString(folder.resolve("one/report.html"));
    assertThat(html).containsPattern(REPORT_HEAD);
    assertThat(html)
        .contains("Mode local:", "Columbia AVENUE", "ICR, odometry alone", "waypoint error")
        .contains("<td>atrv1, true</td>", "class=\"verdict met\">All 4 targets are met.")
        // In lock-step both have one clock: what is measured is what their latencies differ by.
        .containsPattern(
            "clock offset to atrv1</td><td class=\"n\">-</td><td class=\"n\">"
                + "[+-]0\\.00\\d\u00a0s ±\u00a00\\.0\\d+\u00a0s<")
        .contains("by both estimates")
        .contains(" is away and ", "GPS fixes", "required minimum")
        .doesNotContain("no data", "NaN");
    for (String each : FIGURES) {
      assertThat(
              DocumentBuilderFactory.newInstance()
                  .newDocumentBuilder()
                  .parse(folder.resolve("one").resolve(each).toFile())
                  .getDocumentElement()
                  .getTagName())
          .as(each)
          .isEqualTo("svg");
    }
  }

  private static Map<String, String> files(Path folder, String ending) throws IOException {
    Map<String, String> files = new TreeMap<>();
    try (Stream<Path> all = Files.list(folder)) {
      for (Path each : all.filter(file -> file.toString().endsWith(ending)).toList()) {
        files.put(each.getFileName().toString(), Files.readString(each));
      }
    }
    return files;
  }
}
