package org.dfra.examples.raster;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dfra.behaviors.raster.RasterPlan;
import org.dfra.examples.harness.DemoRunner;
import org.dfra.examples.harness.DemoRunner.Demo;
import org.dfra.examples.mission.Mission;
import org.dfra.examples.mission.MissionResult;
import org.dfra.examples.mission.MissionResult.RobotMissionResult;
import org.dfra.examples.mission.Scenario;
import org.dfra.examples.mission.Scores;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.report.progress.QuantityText;
import org.dfra.report.terminal.Table;

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

  private final ProgressReporter progress;
  private final Scenario scenario;
  private final SimulationSpeed simulationSpeed;
  private final Mission mission;
  private final Path report;

  private RasterDemo(ProgressReporter progress, RasterSetup setup, Path report) {
    this.progress = progress;
    this.scenario = setup.scenario();
    this.simulationSpeed = setup.simulationSpeed();
    this.mission = MissionModes.of(setup, progress.figures());
    this.report = report;
  }

  /**
   * The demonstration for these options; starts nothing.
   *
   * @param report the folder of its report
   * @throws RuntimeException if the options are invalid; the message is for the user
   */
  public static RasterDemo of(ProgressReporter progress, RasterOptions options, Path report) {
    return new RasterDemo(progress, RasterSetup.of(options), report);
  }

  @Override
  public boolean run() {
    return DemoRunner.runStandalone(progress, this::play); // a mission has its own
  }

  private void play() throws Exception {
    plan();
    MissionResult flight = search();
    List<Scores> scores = judge(flight);
    progress.section("writing the report", "The report");
    Path file =
        new RasterReport(
                scenario, MissionModes.meaning(mission), flight, scores, progress.figures())
            .write(report);
    progress.say("Figures and tables are in %s, the numbers beside it as CSV.", file);
  }

  private void plan() {
    progress.section("planning", "Planning lanes in the region");
    RasterPlan plan = scenario.plan();
    progress.say(
        "The region around %s has %.0f m². With lanes %.2f m apart, the plan has %s, %d waypoints"
            + " and a path of %.0f m.",
        QuantityText.place(scenario.region().centre()),
        scenario.region().area(),
        plan.spacing(),
        QuantityText.count(plan.lanes().size(), "lane"),
        plan.waypoints().size(),
        plan.length());
    progress.say("%s", MissionModes.meaning(mission));
    simulationSpeed.slowdownReason().ifPresent(why -> progress.say("%s", why));
  }

  private MissionResult search() throws Exception {
    progress.section(
        "searching", "The robots search it, each in the opposite direction to the previous one");
    ProgressReporter.Stopwatch watch = progress.stopwatch();
    MissionResult flight = mission.run(new LiveProgress(progress, System::nanoTime, scenario));
    progress.freezeLive();
    progress.say(
        "The search took %.0f s of the robots' time and %s of real time.",
        flight.seconds(), QuantityText.seconds(watch.elapsed()));
    for (RobotMissionResult each : flight.robots()) {
      progress.say("%s: %s.", each.robot(), each.ending());
    }
    return flight;
  }

  private List<Scores> judge(MissionResult flight) {
    progress.section("judging", "Results of the search");
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
    progress.show(table);
    double clearance = scores.stream().mapToDouble(Scores::clearance).min().orElse(0);
    long unfinished = scores.stream().filter(each -> !each.completed()).count();
    progress.figure("robots that did not come to the end of their lanes", unfinished, 0, "");
    progress.figure("collisions", flight.collisions().size(), 0, "");
    progress.figure(
        "least clearance short of 0.3 m", // targets of measured values are upper limits
        Math.max(0, RasterCharts.LEAST_CLEARANCE - clearance),
        0,
        "m");
    progress.figure("share of the region that no robot saw", 1 - together, MOST_UNSEEN, "");
    return scores;
  }
}
