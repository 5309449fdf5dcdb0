package org.dfra.examples.raster;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import org.dfra.behaviors.raster.CoverageMap;
import org.dfra.behaviors.raster.RasterPlan;
import org.dfra.behaviors.raster.RasterPlan.Lane;
import org.dfra.examples.map.FieldMap;
import org.dfra.examples.mission.CrossTrackError;
import org.dfra.examples.mission.GroundTruthClearance;
import org.dfra.examples.mission.MissionProgressListener.MissionEvent;
import org.dfra.examples.mission.MissionResult;
import org.dfra.examples.mission.MissionResult.RobotMissionResult;
import org.dfra.examples.mission.ModuleReadings.Advice;
import org.dfra.examples.mission.ModuleReadings.ClearanceReading;
import org.dfra.examples.mission.ModuleReadings.Fix;
import org.dfra.examples.mission.ReceiverOutage;
import org.dfra.examples.mission.RobotLog.Sample;
import org.dfra.examples.mission.Scenario;
import org.dfra.examples.mission.Scores;
import org.dfra.examples.raster.Downsampling.Bin;
import org.dfra.geometry.LocalFrame;
import org.dfra.report.plot.Axis;
import org.dfra.report.plot.HeatPanel;
import org.dfra.report.plot.LinePanel;
import org.dfra.report.plot.Page;
import org.dfra.report.plot.Panel;
import org.dfra.report.plot.PathPanel;
import org.dfra.report.plot.Series;

/** The figures of a search over place and time. */
final class RasterCharts {

  /** Target of the minimum clearance, metres. */
  static final double LEAST_CLEARANCE = 0.3;

  private static final Axis TIME = Axis.of("time", "s");
  private static final Axis EAST = FieldMap.EAST;
  private static final Axis NORTH = FieldMap.NORTH;
  private static final int EACH = 5; // samples of a path: two per second
  private static final double BIN = 1; // seconds
  private static final int HIGH = 250; // pixels of a panel over time
  private static final int MAP = 470; // pixels of a map beside another

  /** Names that have the same colours in every figure; the series have no data. */
  private static final Series TRULY = Series.line("true", new double[0], new double[0]);

  private static final Series BELIEVED = Series.line("estimated", new double[0], new double[0]);

  private final Scenario scenario;
  private final MissionResult flight;
  private final FieldMap map;
  private final List<Series> ground;

  RasterCharts(Scenario scenario, MissionResult flight) {
    this.scenario = scenario;
    this.flight = flight;
    this.map = new FieldMap(scenario.world(), scenario.region().frame());
    this.ground = FieldBackground.of(scenario);
  }

  /** The true paths of all robots. */
  Page paths() {
    Map<String, double[][]> ways = new LinkedHashMap<>();
    for (RobotMissionResult robot : flight.robots()) {
      ways.put(
          robot.robot(), Downsampling.thinned(robot.samples(), EACH, Sample::east, Sample::north));
    }
    return new Page("True paths").row(800, map.paths(ground, ways));
  }

  /** For each robot its true, estimated and received positions. */
  Page estimates() {
    List<Panel> panels = new ArrayList<>();
    for (RobotMissionResult robot : flight.robots()) {
      double[][] fixes = Downsampling.thinned(robot.readings().fixes(), 1, Fix::east, Fix::north);
      double[][] believed =
          Downsampling.thinned(
              robot.samples(), EACH, Sample::estimatedEast, Sample::estimatedNorth);
      double[][] way = Downsampling.thinned(robot.samples(), EACH, Sample::east, Sample::north);
      panels.add(
          new PathPanel(robot.robot(), EAST, NORTH)
              .add(ground.toArray(Series[]::new))
              .add(TRULY, BELIEVED) // first, so that colours match others
              .add(Series.points("GPS fixes", fixes[0], fixes[1]).faint())
              .addPath(Series.line(BELIEVED.name(), believed[0], believed[1]))
              .addPath(Series.line(TRULY.name(), way[0], way[1]))
              .add(map.obstacles()));
    }
    return rows("True and estimated path of each robot", MAP + 40, panels);
  }

  /** The area that each robot saw of the region. */
  Page coverage() {
    List<Panel> panels = new ArrayList<>();
    for (int i = 0; i < flight.robots().size(); i++) {
      RobotMissionResult robot = flight.robots().get(i);
      RasterPlan plan = scenario.plan(i);
      CoverageMap seen = plan.coverageMap(Scores.trajectory(robot.samples()), plan.swath());
      double[][] way = Downsampling.thinned(robot.samples(), EACH, Sample::east, Sample::north);
      panels.add(
          new HeatPanel(
                  robot.robot(),
                  EAST.between(seen.west(), seen.east()),
                  NORTH.between(seen.south(), seen.north()),
                  Axis.of("seen", ""),
                  cells(seen))
              .asMap()
              .whereNumbersMean("never", "once", "more")
              .whereMissing("outside the region")
              .add(Series.line("", way[0], way[1]).faint()));
    }
    return rows("Number of passes over each place", MAP, panels);
  }

  private static double[][] cells(CoverageMap map) {
    return map.passes().stream()
        .map(
            row ->
                row.stream()
                    .mapToDouble(each -> each == CoverageMap.OUTSIDE ? Double.NaN : each)
                    .toArray())
        .toArray(double[][]::new);
  }

  /** The clearance over time. */
  Page clearance() {
    LinePanel clearance =
        new LinePanel(
                "Distance from the body to the nearest object", TIME, Axis.of("clearance", "m"))
            .limit(LEAST_CLEARANCE, "required minimum");
    for (RobotMissionResult robot : flight.robots()) {
      clearance.add(over(robot.robot(), robot.samples(), Bin.MIN, Sample::time, Sample::clearance));
    }
    Page page =
        new Page("Clearance, and the encounters of the robots").row(HIGH, marked(clearance));
    if (flight.robots().size() > 1) {
      page.row(HIGH, marked(bodyDistance()));
      page.row(HIGH, marked(separation()));
    }
    return page;
  }

  /** Samples of all robots have the same times. */
  private LinePanel bodyDistance() {
    GroundTruthClearance bodies = new GroundTruthClearance(scenario.world());
    LinePanel panel = new LinePanel("Distance from body to body", TIME, Axis.of("distance", "m"));
    RobotMissionResult first = flight.robots().get(0);
    for (RobotMissionResult other : flight.robots().subList(1, flight.robots().size())) {
      int moments = Math.min(first.samples().size(), other.samples().size());
      List<double[]> distances = new ArrayList<>();
      for (int i = 0; i < moments; i++) {
        Sample at = first.samples().get(i);
        double separation =
            bodies.distance(first.robot(), at, other.robot(), other.samples().get(i));
        distances.add(new double[] {at.time(), separation});
      }
      panel.add(
          over(
              first.robot() + " to " + other.robot(),
              distances,
              Bin.MIN,
              each -> each[0],
              each -> each[1]));
    }
    return panel;
  }

  /** The separation that the first robot reported, and the true one. */
  private LinePanel separation() {
    LinePanel panel = new LinePanel("Distance from base to base", TIME, Axis.of("distance", "m"));
    RobotMissionResult first = flight.robots().get(0);
    for (RobotMissionResult other : flight.robots().subList(1, flight.robots().size())) {
      List<RobotSeparation> all = RobotSeparation.all(first, other);
      String both = first.robot() + " to " + other.robot();
      panel.add(
          over(both + ", true", all, Bin.MEAN, RobotSeparation::time, RobotSeparation::actual),
          over(
              both + ", by both estimates",
              all,
              Bin.MEAN,
              RobotSeparation::time,
              RobotSeparation::estimated));
    }
    return panel;
  }

  /** The cross-track error of each robot. */
  Page crossTrack() {
    Page page = new Page("Cross-track error, left is +; without turns");
    for (int i = 0; i < flight.robots().size(); i++) {
      RobotMissionResult robot = flight.robots().get(i);
      List<CrossTrackError> off = CrossTrackError.all(robot.samples(), scenario.plan(i));
      LinePanel panel =
          new LinePanel(robot.robot(), TIME, Axis.of("off", "m"))
              .add(
                  over(TRULY.name(), off, Bin.MEAN, CrossTrackError::time, CrossTrackError::actual),
                  over(
                      BELIEVED.name(),
                      off,
                      Bin.MEAN,
                      CrossTrackError::time,
                      CrossTrackError::estimated));
      for (ReceiverOutage each : ReceiverOutage.all(robot)) {
        panel.span(each.from(), each.to(), each.receiver() + " silent");
      }
      page.row(HIGH, marked(panel, each -> each.robot().equals(robot.robot())));
    }
    return page;
  }

  /** The inputs and outputs of the fuzzy rules. */
  Page fuzzy() {
    LinePanel clearance = new LinePanel("Clearance", TIME, Axis.of("minimum", "m"));
    LinePanel speed = new LinePanel("Advised speed", TIME, Axis.of("speed", "m/s"));
    LinePanel turn = new LinePanel("Advised yaw rate, left is +", TIME, Axis.of("rate", "rad/s"));
    for (RobotMissionResult robot : flight.robots()) {
      List<Advice> advice = robot.readings().advice();
      clearance.add(
          over(
              robot.robot(),
              robot.readings().clearances(),
              Bin.MIN,
              ClearanceReading::time,
              each -> Math.min(each.centre(), Math.min(each.left(), each.right()))));
      speed.add(over(robot.robot(), advice, Bin.MEAN, Advice::time, Advice::speed));
      turn.add(over(robot.robot(), advice, Bin.MEAN, Advice::time, Advice::yawRate));
    }
    return new Page("The fuzzy rules").row(HIGH, clearance).row(HIGH, speed).row(HIGH, turn);
  }

  private LinePanel marked(LinePanel panel) {
    return marked(panel, each -> true);
  }

  /** Marks each event with its number in the list of events; later events are marked at the end. */
  private LinePanel marked(LinePanel panel, Predicate<MissionEvent> shown) {
    for (int i = 0; i < flight.events().size(); i++) {
      MissionEvent each = flight.events().get(i);
      if (shown.test(each)) {
        panel.note(Math.min(each.time(), flight.seconds()), i + 1);
      }
    }
    return panel;
  }

  private static <T> Series over(
      String name, List<T> all, Bin bin, ToDoubleFunction<T> time, ToDoubleFunction<T> number) {
    double[][] points = Downsampling.binned(all, BIN, bin, time, number);
    return Series.line(name, points[0], points[1]);
  }

  /** Two panels in a row; a single panel takes the whole row. */
  private static Page rows(String title, int height, List<Panel> panels) {
    Page page = new Page(title);
    for (int i = 0; i < panels.size(); i += 2) {
      page.row(height, panels.subList(i, Math.min(i + 2, panels.size())).toArray(Panel[]::new));
    }
    return page;
  }

  /** The searched region and its lanes, as series in the region's frame. */
  private static final class FieldBackground {

    private FieldBackground() {}

    /** To be drawn first. */
    static List<Series> of(Scenario scenario) {
      LocalFrame frame = scenario.region().frame();
      Series region =
          FieldMap.outline("", scenario.region().corners().stream().map(frame::toLocal).toList());
      List<Double> x = new ArrayList<>();
      List<Double> y = new ArrayList<>();
      for (Lane lane : scenario.plan().lanes()) {
        x.addAll(List.of(lane.from().east(), lane.to().east(), lane.to().east()));
        y.addAll(List.of(lane.from().north(), lane.to().north(), Double.NaN)); // lanes do not join
      }
      return List.of(region.faint(), Series.line("", array(x), array(y)).faint());
    }

    private static double[] array(List<Double> all) {
      return all.stream().mapToDouble(Double::doubleValue).toArray();
    }
  }
}
