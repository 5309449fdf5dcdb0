package org.dfra.app.demo.raster;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import org.dfra.app.demo.map.MissionEventList;
import org.dfra.app.measurement.ReportHead;
import org.dfra.app.measurement.RunMeasurements;
import org.dfra.app.plot.HtmlReport;
import org.dfra.app.plot.Page;
import org.dfra.app.plot.TablePanel;
import org.dfra.app.raster.MissionResult;
import org.dfra.app.raster.Scenario;
import org.dfra.app.raster.Scores;
import org.dfra.behaviors.raster.RasterPlan;

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
    html.heading("The numbers")
        .paragraph(
            "Beside this file are every figure as SVG and every number as CSV. In figures over"
                + " time a second is one point: the least clearance in it, the mean of everything"
                + " else. Paths have two points a second.");
    Path file = folder.resolve("report.html");
    html.write(file);
    return file;
  }

  private String asked() {
    RasterPlan plan = scenario.plan();
    return String.format(
        Locale.ROOT,
        "The region has %.0f m². A robot sees a strip of %.2f m; %d lanes, %.2f m apart, make a way"
            + " of %.0f m with %d waypoints. Each robot drives all of it, every second one the"
            + " other way round, so that they meet. The world is \"%s\", its seed %d.",
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
    new Page("How well they searched")
        .row(panel.height(), panel)
        .write(folder.resolve("metrics.svg"));
    html.heading("How well they searched").table(metrics.headings(), metrics.rows());
    html.paragraph(
        "Off its lanes means across them, without the two metres at either end, where a robot"
            + " turns. A waypoint is missed by how near the robot truly came to it while it was the"
            + " next one. Around an obstacle every robot leaves its lane. The first robot follows the"
            + " others by what they tell; the distance to each is between both estimates.");
    MetricsTable beside = MetricsTable.besidePublished(flight, scores);
    html.table(beside.headings(), beside.rows());
    html.paragraph(
        "Published figures of others stand here for their size only: theirs were real robots on"
            + " other ground, without obstacles on their way.");
  }

  private void figures(Path folder, HtmlReport html) throws IOException {
    RasterCharts figures = new RasterCharts(scenario, flight);
    html.heading("Where they went");
    add(
        folder.resolve("paths.svg"),
        html,
        figures.paths(),
        "Truly, by the simulated world. A ring is where a robot started, a square where it ended;"
            + " arrows show its direction. The region and its lanes are grey.");
    add(
        folder.resolve("estimates.svg"),
        html,
        figures.estimates(),
        "Each robot steers by its estimate. A lasting error of its receivers moves the whole.");
    html.heading("What they saw");
    add(
        folder.resolve("coverage.svg"),
        html,
        figures.coverage(),
        "Counted truly, half a swath to either side of the way, which is drawn above.");
    html.heading("How near they came to anything");
    add(
        folder.resolve("clearance.svg"),
        html,
        figures.clearance(),
        "Obstacles and the other robot count alike. Where the second curve falls, they met. By both"
            + " estimates is what a robot told of the other at one instant, by the offset of their"
            + " clocks."
            + numbered());
    html.heading("How well they kept their lanes");
    add(
        folder.resolve("cross-track.svg"),
        html,
        figures.crossTrack(),
        "Grey bands are times in which a receiver told no position." + numbered());
    html.heading("What the fuzzy rules advised");
    add(
        folder.resolve("fuzzy.svg"),
        html,
        figures.fuzzy(),
        "Room is the least of left, ahead and right by the range filter, which reaches 8 m.");
  }

  private static void add(Path svg, HtmlReport html, Page page, String caption) throws IOException {
    html.figure(page, caption, svg);
  }

  private void rules(HtmlReport html) {
    List<List<String>> table = DominantRules.table(flight, RULES);
    if (table.size() > 1) {
      html.paragraph(
          "Ten times a second the rules are asked. These were the loudest most often; a count for"
              + " each robot.");
      html.table(table.get(0), table.subList(1, table.size()));
    }
  }

  /** The caption's note about numbered events. */
  private String numbered() {
    return flight.events().isEmpty() ? "" : " The numbers are those of what happened on the way.";
  }
}
