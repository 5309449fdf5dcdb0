package org.dfra.app.demo.raster;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dfra.app.demo.harness.Demo;
import org.dfra.app.demo.harness.DemoRunner;
import org.dfra.app.demo.harness.ProgressReporter;
import org.dfra.app.demo.harness.QuantityText;
import org.dfra.app.raster.Mission;
import org.dfra.app.raster.MissionResult;
import org.dfra.app.raster.MissionResult.RobotMissionResult;
import org.dfra.app.raster.Scenario;
import org.dfra.app.raster.Scores;
import org.dfra.app.terminal.Table;
import org.dfra.behaviors.raster.RasterPlan;

/**
 * Plans lanes for an operator's region; robots search it, each in the opposite direction to the one
 * before it, so that they meet; writes a report of the results.
 */
public final class RasterDemo implements Demo {

  /**
   * A robot that goes around a post, or whose receiver drifts, leaves some ground to the other;
   * edges make up most of a small region.
   */
  private static final double MOST_UNSEEN = 0.05;

  private final ProgressReporter tell;
  private final Scenario scenario;
  private final SimulationSpeed pace;
  private final Mission mission;
  private final Path report;

  private RasterDemo(ProgressReporter narration, RasterSetup setup, Path report) {
    this.tell = narration;
    this.scenario = setup.scenario();
    this.pace = setup.pace();
    this.mission = MissionModes.of(setup, narration.figures());
    this.report = report;
  }

  /**
   * The demonstration for these options; starts nothing.
   *
   * @param report the folder of its report
   * @throws RuntimeException if the options are invalid; the message is for the user
   */
  public static RasterDemo of(ProgressReporter narration, RasterOptions options, Path report) {
    return new RasterDemo(narration, RasterSetup.of(options), report);
  }

  @Override
  public boolean run() {
    return DemoRunner.runStandalone(tell, this::play); // a mission has its own
  }

  private void play() throws Exception {
    plan();
    MissionResult flight = search();
    List<Scores> scores = judge(flight);
    tell.chapter("writing the report", "The report");
    Path file =
        new RasterReport(scenario, MissionModes.meaning(mission), flight, scores, tell.figures())
            .write(report);
    tell.say("Figures and tables are in %s, the numbers beside it as CSV.", file);
  }

  private void plan() {
    tell.chapter("planning", "A region becomes lanes");
    RasterPlan plan = scenario.plan();
    tell.say(
        "The region around %s has %.0f m². With lanes %.2f m apart that makes %s, %d waypoints and"
            + " %.0f m to drive.",
        QuantityText.place(scenario.region().centre()),
        scenario.region().area(),
        plan.spacing(),
        QuantityText.count(plan.lanes().size(), "lane"),
        plan.waypoints().size(),
        plan.length());
    tell.say("%s", MissionModes.meaning(mission));
    pace.slowdownReason().ifPresent(why -> tell.say("%s", why));
  }

  private MissionResult search() throws Exception {
    tell.chapter("searching", "The robots search it, each the other way round than the one before");
    ProgressReporter.Stopwatch watch = tell.stopwatch();
    MissionResult flight = mission.run(new LiveProgress(tell, System::nanoTime, scenario));
    tell.freezeLive();
    tell.say(
        "The search took %.0f s of the robots' time and %s of this computer's.",
        flight.seconds(), QuantityText.seconds(watch.elapsed()));
    for (RobotMissionResult each : flight.robots()) {
      tell.say("%s: %s.", each.robot(), each.ending());
    }
    return flight;
  }

  private List<Scores> judge(MissionResult flight) {
    tell.chapter("judging", "How well they searched");
    List<Scores> scores = new ArrayList<>();
    for (int i = 0; i < flight.robots().size(); i++) {
      scores.add(Scores.of(flight.robots().get(i), scenario.plan(i)));
    }
    double together = Scores.teamCoverage(flight, scenario);
    MetricsTable metrics = MetricsTable.of(flight, scores, together);
    Table table =
        new Table(
            metrics.headings().stream()
                .map(each -> each.toUpperCase(Locale.ROOT))
                .toArray(String[]::new));
    metrics.rows().forEach(row -> table.row(row.toArray(String[]::new)));
    tell.show(table);
    double clearance = scores.stream().mapToDouble(Scores::clearance).min().orElse(0);
    long unfinished = scores.stream().filter(each -> !each.completed()).count();
    tell.figure("robots that did not come to the end of their lanes", unfinished, 0, "");
    tell.figure("collisions", flight.collisions().size(), 0, "");
    tell.figure(
        "least clearance short of 0.3 m", // targets of measured values are upper limits
        Math.max(0, RasterCharts.LEAST_CLEARANCE - clearance),
        0,
        "m");
    tell.figure("share of the region that no robot saw", 1 - together, MOST_UNSEEN, "");
    return scores;
  }
}
