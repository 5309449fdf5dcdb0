package org.dfra.examples.raster;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import org.dfra.behaviors.raster.RasterPlan;
import org.dfra.examples.map.MissionEventList;
import org.dfra.examples.mission.MissionResult;
import org.dfra.examples.mission.Scenario;
import org.dfra.examples.mission.Scores;
import org.dfra.report.measurement.ReportHead;
import org.dfra.report.measurement.RunMeasurements;
import org.dfra.report.plot.HtmlReport;
import org.dfra.report.plot.Page;
import org.dfra.report.plot.TablePanel;

/**
 * Writes the report of a search: a page with figures and tables, each figure as SVG, all numbers as
 * CSV.
 */
final class RasterReport {

  private static final int RULES = 10;

  private final Scenario scenario;
  private final String mode;
  private final MissionResult flight;
  private final List<Scores> scores;
  private final RunMeasurements measured;

  /**
   * @param mode in which it was run, and its explanation
   * @param scores of the robots, in their order
   * @param measured values that decide whether it passed
   */
  RasterReport(
      Scenario scenario,
      String mode,
      MissionResult flight,
      List<Scores> scores,
      RunMeasurements measured) {
    this.scenario = scenario;
    this.mode = mode;
    this.flight = flight;
    this.scores = scores;
    this.measured = measured;
  }

  /**
   * Writes it.
   *
   * @return the file to open
   */
  Path write(Path folder) throws IOException {
    Files.createDirectories(folder);
    new RasterCsv(folder).write(scenario, flight, scores);
    HtmlReport html = new HtmlReport("Searching a field by raster");
    ReportHead.add(html, measured, Instant.now());
    html.paragraph(mode).paragraph(asked());
    metrics(folder, html);
    MissionEventList.addTo(flight.events(), html);
    figures(folder, html);
    rules(html);
    html.heading("Files")
        .paragraph(
            "Beside this file are all figures as SVG and all numbers as CSV. Figures over time have"
                + " one point per second: the minimum of the clearance, and the mean of all other"
                + " values. Paths have two points per second.");
    Path file = folder.resolve("report.html");
    html.write(file);
    return file;
  }

  private String asked() {
    RasterPlan plan = scenario.plan();
    return String.format(
        Locale.ROOT,
        "The region has %.0f m². A robot sees a strip of %.2f m; %d lanes, %.2f m apart, make a"
            + " path of %.0f m with %d waypoints. Each robot drives the whole path, every second"
            + " one in the opposite direction, so that they meet. The world is \"%s\", its seed %d.",
        scenario.region().area(),
        plan.swath(),
        plan.lanes().size(),
        plan.spacing(),
        plan.length(),
        plan.waypoints().size(),
        scenario.world().name(),
        scenario.world().seed());
  }

  private void metrics(Path folder, HtmlReport html) throws IOException {
    MetricsTable metrics = MetricsTable.of(flight, scores, Scores.teamCoverage(flight, scenario));
    TablePanel panel = new TablePanel(metrics.headings(), metrics.rows());
    new Page("Results of the search")
        .row(panel.height(), panel)
        .write(folder.resolve("metrics.svg"));
    html.heading("Results of the search").table(metrics.headings(), metrics.rows());
    html.paragraph(
        "The cross-track error is measured across the lanes, without the two metres at either end,"
            + " where a robot turns. The error of a waypoint is the robot's smallest true distance"
            + " from it while it was the next one. Every robot leaves its lane around an obstacle."
            + " The first robot tracks the others by their messages; the distance to each is"
            + " between both estimates.");
    MetricsTable beside = MetricsTable.besidePublished(flight, scores);
    html.table(beside.headings(), beside.rows());
    html.paragraph(
        "Published results are given for their order of magnitude only: they are of real robots on"
            + " other ground, without obstacles on their path.");
  }

  private void figures(Path folder, HtmlReport html) throws IOException {
    RasterCharts figures = new RasterCharts(scenario, flight);
    html.heading("Paths");
    add(
        folder.resolve("paths.svg"),
        html,
        figures.paths(),
        "True paths in the simulated world. A ring is a robot's start, a square its end; arrows"
            + " show its direction. The region and its lanes are grey.");
    add(
        folder.resolve("estimates.svg"),
        html,
        figures.estimates(),
        "Each robot steers by its estimate. A constant error of its receivers shifts the whole path.");
    html.heading("Coverage");
    add(
        folder.resolve("coverage.svg"),
        html,
        figures.coverage(),
        "Counted by the true path, which is drawn above, with half a swath on either side.");
    html.heading("Clearance");
    add(
        folder.resolve("clearance.svg"),
        html,
        figures.clearance(),
        "Obstacles and the other robot count equally. Where the second curve falls, the robots met."
            + " The distance by both estimates is what a robot reported of the other at one"
            + " instant, with the offset of their clocks."
            + numbered());
    html.heading("Cross-track error");
    add(
        folder.resolve("cross-track.svg"),
        html,
        figures.crossTrack(),
        "Grey bands are times in which a receiver reported no position." + numbered());
    html.heading("Output of the fuzzy rules");
    add(
        folder.resolve("fuzzy.svg"),
        html,
        figures.fuzzy(),
        "Clearance is the minimum of left, ahead and right by the range filter, which reaches 8 m.");
  }

  private static void add(Path svg, HtmlReport html, Page page, String caption) throws IOException {
    html.figure(page, caption, svg);
  }

  private void rules(HtmlReport html) {
    List<List<String>> table = DominantRules.table(flight, RULES);
    if (table.size() > 1) {
      html.paragraph(
          "The rules are evaluated ten times a second. These had the greatest firing strength most"
              + " often; the numbers are counts for each robot.");
      html.table(table.get(0), table.subList(1, table.size()));
    }
  }

  /** The caption's note about numbered events. */
  private String numbered() {
    return flight.events().isEmpty() ? "" : " The numbers refer to the list of events.";
  }
}
