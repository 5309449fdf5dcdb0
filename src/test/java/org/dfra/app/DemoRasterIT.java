package org.dfra.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;

/** {@code ./dfra demo raster}, embedded and with processes. */
@EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "takes minutes")
class DemoRasterIT extends DemoPlay {

  /** Three lanes of 7.5 m in the west of the field. */
  private static final String LANES =
      "48.000022,11.000154 48.000022,11.000224 48.000090,11.000224 48.000090,11.000154";

  /** A smaller region, without processes. */
  @Test
  void theRasterIsSearchedThoughLookupServicesEnd() throws Exception {
    String output =
        play(
            "raster",
            List.of("--embedded", "--speed=3", "--region=" + LANES),
            "Planning lanes in the region",
            "lanes 1.74 m apart, the plan has 3 lanes",
            "Mode embedded: all robots run in one virtual machine",
            "The robots search it, each in the opposite direction to the previous one",
            "its registrar is ended, which listed its",
            "The search took",
            "atrv1: the region is searched: it has reached all waypoints.",
            "atrv2: the region is searched: it has reached all waypoints.",
            "Results of the search",
            "completed its lanes yes yes",
            "collisions 0 0",
            "Measured",
            "registrar back to all modules listed again",
            "registrar back: modules that are listed under another service ID 0 target ≤ 0",
            "atrv2: lateness of 99 % of the control loop's last turns",
            "robots that did not come to the end of their lanes 0 target ≤ 0",
            "collisions 0 target ≤ 0",
            "share of the region that no robot saw");
    assertThat(output)
        .containsSubsequence(
            "atrv2: its registrar is ended", "atrv2: its registrar is back and lists its")
        .containsSubsequence("atrv1: its registrar is ended", "were without its registrar");
    assertReport("Mode embedded", "its registrar is ended");
  }

  /**
   * Minutes of processes that are killed, while the robots search the middle of the field: what a
   * user sees who says no more than {@code ./dfra demo}.
   */
  @Test
  void theRasterIsSearchedThoughProcessesAreKilled() throws Exception {
    String output =
        play(
            "raster",
            List.of(),
            "Planning lanes in the region",
            "6 lanes, 12 waypoints",
            "Mode processes: each robot has its phoenix",
            "The search took",
            "atrv1: the region is searched: it has reached all waypoints.",
            "atrv2: the region is searched: it has reached all waypoints.",
            "completed its lanes yes yes",
            "collisions 0 0",
            "Measured",
            "robots that did not come to the end of their lanes 0 target ≤ 0",
            "collisions 0 target ≤ 0");
    assertThat(output)
        .containsSubsequence("atrv1: gps_front is killed", "atrv1: gps_front is back")
        .containsSubsequence(
            "atrv1: navigation is killed",
            "atrv1: its wheels have stopped",
            "atrv1: it continues by itself")
        .containsSubsequence(
            "atrv1: drive is killed",
            "atrv1: its wheels have stopped",
            "atrv1: it continues by itself")
        .containsSubsequence(
            "atrv2: its phoenix and its registrar are killed",
            "it continues to drive",
            "atrv2: phoenix runs again")
        .contains(
            "gps_front killed to readings received again",
            "navigation killed: last command to wheels standing (robot's time)",
            "navigation killed: waypoints to be driven to again 0 target ≤ 0",
            "drive killed: waypoints to be driven to again 0 target ≤ 0",
            "phoenix back: living groups that have another process 0 target ≤ 0");
    assertReport("Mode processes", "navigation is killed");
  }

  private void assertReport(String... contents) throws Exception {
    Path report = report();
    assertThat(Files.readString(report.resolve("report.html")))
        .contains("Paths", "Events", "<svg")
        .contains(contents);
    try (var files = Files.list(report)) {
      assertThat(files.map(file -> file.getFileName().toString()))
          .contains("paths.svg", "clearance.svg", "fuzzy.svg", "metrics.csv", "events.csv")
          .contains("atrv1-path.csv", "atrv2-path.csv", "atrv1-advice.csv", "atrv2-fixes.csv");
    }
    for (String robot : List.of("atrv1", "atrv2")) {
      assertThat(Files.readAllLines(report.resolve(robot + "-path.csv")))
          .as("ten times a second")
          .hasSizeGreaterThan(200);
    }
    assertThat(Files.readAllLines(report.resolve("collisions.csv"))).as("a header").hasSize(1);
  }
}
