package org.dfra.benchmarks;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import java.util.function.UnaryOperator;
import org.dfra.behaviors.raster.Region;
import org.dfra.core.config.RobotDescription;
import org.dfra.examples.mission.LockStepMission;
import org.dfra.examples.mission.MissionResult;
import org.dfra.examples.mission.MissionResult.RobotMissionResult;
import org.dfra.examples.mission.Scenario;
import org.dfra.examples.mission.Scores;
import org.dfra.experiments.navigation.BlindRangeFilterImpl;
import org.dfra.experiments.navigation.ConfidenceInterval;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.report.measurement.ReportHead;
import org.dfra.report.measurement.RunMeasurements;
import org.dfra.report.plot.HtmlReport;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.description.WorldDescription.ObstacleDescription;
import org.dfra.sim.world.file.WorldXml;
import org.dfra.sim.world.shape.PlanarShape.Vertex;

/**
 * Measures how well robots search a field by raster: many searches in lock-step, each with another
 * seed, under several conditions, one of which must fail.
 */
final class NavigationBench implements Bench {

  private static final Path ROOT = Path.of(System.getProperty("dfra.root", "."));
  private static final Path WORLD = ROOT.resolve("config/worlds/raster.xml");
  private static final Path TEAM = ROOT.resolve("config/teams/raster");
  private static final Duration LONGEST = Duration.ofMinutes(40);
  private static final double SWATH = 2.5; // metres
  private static final double SPACING = 2; // metres
  private static final double LOW_BIAS = 0.2; // metres
  private static final int POSTS = 8;

  /**
   * The condition of a series of runs.
   *
   * @param robots the searching robots
   * @param posts number of posts in the field
   * @param gpsBiasSigma standard deviation of the receivers' bias, metres
   * @param adapt changes each robot's description for this condition
   * @param endsAtCollision whether a run ends at the first collision
   */
  private record Condition(
      String name,
      int robots,
      int posts,
      double gpsBiasSigma,
      UnaryOperator<RobotDescription> adapt,
      boolean endsAtCollision) {}

  private static final Condition NOMINAL =
      new Condition(
          "alone",
          1,
          0,
          0,
          robot ->
              ScenarioVariations.withVariants(
                  robot, LockStepMission.STEERING, "method", List.of("fix_window", "raw")),
          false);
  private static final Condition MEETING =
      new Condition("meeting", 2, 0, LOW_BIAS, robot -> robot, false);
  private static final Condition CROWDED =
      new Condition("posts", 2, POSTS, LOW_BIAS, robot -> robot, false);
  private static final Condition BLIND =
      new Condition(
          "blind",
          2,
          0,
          LOW_BIAS,
          robot ->
              ScenarioVariations.withDriver(
                  robot, "range_filter", BlindRangeFilterImpl.class.getName()),
          true);

  /**
   * The result of one seed under one condition.
   *
   * @param coverage share of the region that the robot with the smallest coverage saw
   * @param together share of the region that the robots saw together
   */
  private record Outcome(
      Condition condition,
      long seed,
      MissionResult flight,
      List<Scores> scores,
      double coverage,
      double together) {

    boolean collided() {
      return !flight.collisions().isEmpty();
    }

    double clearance() {
      return scores.stream().mapToDouble(Scores::clearance).min().orElse(0);
    }

    double error(String estimator) {
      return flight.robots().get(0).errors().getOrDefault(estimator, Double.NaN);
    }
  }

  private final int seeds;
  private final Path folder;

  /**
   * @param seeds number of seeds, from 1 on
   * @param folder for its report
   */
  NavigationBench(int seeds, Path folder) {
    this.seeds = seeds;
    this.folder = folder;
  }

  @Override
  public void run(Report report) throws Exception {
    WorldDescription world = WorldXml.read(WORLD, name -> null);
    report.say(
        seeds
            + " seeds under each of four conditions, in lock-step (mode: local). Intervals are of"
            + " 95 %.");
    List<Outcome> all = new ArrayList<>();
    Files.createDirectories(folder);
    List<List<String>> rows = new ArrayList<>();
    for (Condition each : List.of(NOMINAL, MEETING, CROWDED, BLIND)) {
      long began = System.nanoTime();
      List<Outcome> outcomes = runs(world, each);
      all.addAll(outcomes);
      judge(report, each, outcomes, rows);
      report.say(
          String.format(
              Locale.ROOT, "  (%.0f s of this machine)", (System.nanoTime() - began) / 1e9));
    }
    write(all, folder.resolve("runs.csv"));
    page(seeds, report.figures(), rows).write(folder.resolve("report.html"));
    report.say("The report: " + folder.resolve("report.html"));
  }

  /**
   * What the report shows.
   *
   * @param rows condition, figure and value with its interval
   */
  static HtmlReport page(int seeds, RunMeasurements measured, List<List<String>> rows) {
    HtmlReport html = new HtmlReport("Searching by raster: " + seeds + " seeds");
    ReportHead.add(html, measured, Instant.now());
    html.paragraph(
        "Every run is a whole search of the field of config/worlds/raster.xml with real drivers at"
            + " emulated devices, in lock-step (mode: local): the same seed gives the same run."
            + " Robots start up to 1 m and 0.5 rad from where the world has them. Shares have"
            + " Wilson's interval, means that of the bootstrap, both of 95 %.");
    return html.table(List.of("Condition", "Figure", "Value (interval)"), rows);
  }

  private List<Outcome> runs(WorldDescription world, Condition condition)
      throws ExecutionException, InterruptedException {
    ExecutorService threads =
        Executors.newFixedThreadPool(Runtime.getRuntime().availableProcessors());
    try {
      List<Future<Outcome>> futures = new ArrayList<>();
      for (long seed = 1; seed <= seeds; seed++) {
        long chosen = seed;
        futures.add(threads.submit(() -> run(world, condition, chosen)));
      }
      List<Outcome> outcomes = new ArrayList<>();
      for (Future<Outcome> each : futures) {
        outcomes.add(each.get());
      }
      return outcomes;
    } finally {
      threads.shutdownNow();
    }
  }

  private static Outcome run(WorldDescription written, Condition condition, long seed)
      throws IOException {
    Random random = new Random(seed);
    List<VehicleDescription> robots = new ArrayList<>();
    for (int i = 0; i < condition.robots(); i++) {
      robots.add(
          ScenarioVariations.withDeviceParameter(
              ScenarioVariations.withRandomPose(written.vehicles().get(i), 1, 0.5, random),
              DeviceKind.GPS,
              "bias_sigma",
              condition.gpsBiasSigma()));
    }
    List<ObstacleDescription> posts =
        ScenarioVariations.posts(condition.posts(), written, robots, random);
    WorldDescription world = ScenarioVariations.world(written.withSeed(seed), posts, robots);
    Scenario scenario =
        new Scenario(
            world,
            robots.stream().map(robot -> TEAM.resolve(robot.name() + ".xml")).toList(),
            region(world),
            SWATH,
            SPACING);
    MissionResult flight =
        new LockStepMission(
                scenario,
                LONGEST,
                robot -> condition.adapt().apply(knowing(robot, condition.gpsBiasSigma())),
                condition.endsAtCollision())
            .run(now -> {});
    List<Scores> scores = new ArrayList<>();
    List<LocalPosition> driven = new ArrayList<>(); // halves share the waypoint
    for (int i = 0; i < flight.robots().size(); i++) {
      RobotMissionResult each = flight.robots().get(i);
      scores.add(Scores.of(each, scenario.plan(i)));
      each.samples().forEach(s -> driven.add(new LocalPosition(s.east(), s.north(), 0)));
    }
    double coverage = scores.stream().mapToDouble(Scores::coverage).min().orElse(0);
    return new Outcome(
        condition,
        seed,
        flight.withoutSamples(),
        scores,
        coverage,
        scenario.plan().coverage(driven, SWATH).share());
  }

  /** The robot's description with the known receiver error. */
  private static RobotDescription knowing(RobotDescription robot, double gpsBiasSigma) {
    return ScenarioVariations.withParameter(
        robot, LockStepMission.STEERING, "gps_bias_sigma", Double.toString(gpsBiasSigma));
  }

  private static Region region(WorldDescription world) {
    LocalFrame frame = new LocalFrame(world.datum());
    List<GeoPosition> corners = new ArrayList<>();
    for (Vertex each : world.region().orElseThrow().corners()) {
      corners.add(frame.toGeo(new LocalPosition(each.east(), each.north(), 0)));
    }
    return Region.of(corners);
  }

  private static void judge(
      Report report, Condition condition, List<Outcome> outcomes, List<List<String>> rows) {
    int completed = count(outcomes, each -> each.scores().stream().allMatch(Scores::completed));
    int collided = count(outcomes, Outcome::collided);
    ConfidenceInterval collisions = ConfidenceInterval.ofProportion(collided, outcomes.size());
    report.say(condition.name() + ":");
    if (condition == BLIND) {
      report.figure(
          "blind: runs without a collision, share (negative control)",
          1 - collisions.value(),
          0.5,
          "");
      rows.add(List.of(condition.name(), "runs with a collision", collisions.toString()));
      return;
    }
    ConfidenceInterval done = ConfidenceInterval.ofProportion(completed, outcomes.size());
    report.figure(condition.name() + ": runs not completed", outcomes.size() - completed, 0, "");
    report.figure(condition.name() + ": runs with a collision", collided, 0, "");
    rows.add(List.of(condition.name(), "runs completed", done.toString()));
    rows.add(List.of(condition.name(), "runs with a collision", collisions.toString()));
    mean(
        report,
        rows,
        condition,
        "not seen by the robot that saw least",
        outcomes,
        o -> 1 - o.coverage(),
        condition == CROWDED ? Double.POSITIVE_INFINITY : 0.02, // an avoided area is not seen
        "");
    if (condition.robots() > 1) {
      mean(
          report,
          rows,
          condition,
          "not seen by any robot",
          outcomes,
          o -> 1 - o.together(),
          0.02,
          "");
    }
    mean(
        report,
        rows,
        condition,
        "cross-track RMS to the estimate",
        outcomes,
        o -> o.scores().get(0).crossTrack().rms(),
        condition == NOMINAL ? 0.25 : Double.POSITIVE_INFINITY,
        "m");
    if (condition == NOMINAL) {
      estimators(report, rows, outcomes);
    } else {
      double least = outcomes.stream().mapToDouble(Outcome::clearance).min().orElse(0);
      report.figure(condition.name() + ": 0.3 m less the least clearance", 0.3 - least, 0, "m");
      rows.add(
          List.of(
              condition.name(),
              "least clearance of all runs",
              String.format(Locale.ROOT, "%.2f m", least)));
    }
  }

  private static void estimators(Report report, List<List<String>> rows, List<Outcome> outcomes) {
    for (String method : List.of("position", "position_fix_window", "position_raw")) {
      mean(
          report,
          rows,
          NOMINAL,
          "position error RMS, " + method,
          outcomes,
          o -> o.error(method),
          Double.POSITIVE_INFINITY,
          "m");
    }
    mean(
        report,
        rows,
        NOMINAL,
        "EKF's error by the raw fix's",
        outcomes,
        o -> o.error("position") / o.error("position_raw"),
        0.7,
        "");
  }

  private static void mean(
      Report report,
      List<List<String>> rows,
      Condition condition,
      String what,
      List<Outcome> outcomes,
      ToDoubleFunction<Outcome> number,
      double most,
      String unit) {
    ConfidenceInterval interval =
        ConfidenceInterval.ofMean(outcomes.stream().mapToDouble(number).toArray());
    report.figure(condition.name() + ": " + what, interval.value(), most, unit);
    rows.add(
        List.of(condition.name(), what + ", mean", interval + (unit.isEmpty() ? "" : " " + unit)));
  }

  private static int count(List<Outcome> outcomes, Predicate<Outcome> condition) {
    return (int) outcomes.stream().filter(condition).count();
  }

  private static void write(List<Outcome> all, Path file) throws IOException {
    try (BufferedWriter out = Files.newBufferedWriter(file)) {
      out.write(
          "condition,seed,robot,completed,collisions,seconds,length_m,ideal_m,coverage,overlap,"
              + "cross_track_m,true_cross_track_m,cross_track95_m,estimate_error_m,fix_error_m,"
              + "clearance_m,ending\n");
      for (Outcome each : all) {
        for (int i = 0; i < each.scores().size(); i++) {
          Scores s = each.scores().get(i);
          out.write(
              String.format(
                  Locale.ROOT,
                  "%s,%d,%s,%b,%d,%.1f,%.2f,%.2f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.3f,\"%s\"%n",
                  each.condition().name(),
                  each.seed(),
                  each.flight().robots().get(i).robot(),
                  s.completed(),
                  each.flight().collisions().size(),
                  s.seconds(),
                  s.length(),
                  s.plannedLength(),
                  s.coverage(),
                  s.overlap(),
                  s.crossTrack().rms(),
                  s.trueCrossTrack().rms(),
                  s.crossTrack().within95(),
                  s.estimateError(),
                  s.fixError(),
                  s.clearance(),
                  each.flight().robots().get(i).ending()));
        }
      }
    }
  }
}
