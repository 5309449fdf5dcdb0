package org.dfra.examples.raster;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.behaviors.raster.RasterPlan;
import org.dfra.behaviors.raster.Region;
import org.dfra.behaviors.waypoint.WaypointDistanceLimit;
import org.dfra.cli.task.GivenRegion;
import org.dfra.cli.task.LaneSettings;
import org.dfra.core.config.RobotXml;
import org.dfra.core.robot.RobotDryRun;
import org.dfra.core.time.ScaledTime;
import org.dfra.examples.harness.CpuSpeed;
import org.dfra.examples.mission.Scenario;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.file.WorldXml;
import org.dfra.sim.world.shape.PlanarShape.Vertex;

/**
 * A validated search that is ready to start: all errors have been reported.
 *
 * @param scenario the region and the robots
 * @param world the file of the world; its seed is the scenario's, not always the file's
 * @param mode the selected mode
 * @param simulationSpeed speed of the robots' clock
 * @param longest timeout of the search, robots' clock
 */
public record RasterSetup(
    Scenario scenario, Path world, Mode mode, SimulationSpeed simulationSpeed, Duration longest) {

  /** Modes of running a search. */
  public enum Mode {
    /** In processes under phoenix. */
    PROCESSES,
    /** In one JVM, with lookup services. */
    EMBEDDED,
    /** In one JVM, in lock-step. */
    LOCAL
  }

  private static final Path ROOT = Path.of(System.getProperty("dfra.root", "."));
  private static final Path WORLD = ROOT.resolve("config/worlds/raster.xml");
  private static final Path MIDDLE = ROOT.resolve("config/worlds/raster-middle.geojson");
  private static final Path WEST = ROOT.resolve("config/worlds/raster-west.geojson");
  private static final Path TEAM = ROOT.resolve("config/teams/raster");

  private static final Duration TO_BEGIN = Duration.ofMinutes(10);

  /** Metres per second, a quarter of an unobstructed robot's speed. */
  private static final double SLOWEST = 0.15;

  /**
   * A search of a few lanes of the standard field, in processes, for another demonstration.
   *
   * @param speed seconds of the robots' clock per second
   */
  public static RasterSetup inProcesses(double speed) {
    RasterOptions options = new RasterOptions();
    options.speed = speed;
    options.region = WEST.toString();
    return of(options);
  }

  /**
   * The setup for these options.
   *
   * @throws CommandFailure if a number is out of range, or the world has no robots for it
   * @throws org.dfra.core.config.ConfigurationException if a file is invalid
   * @throws GoalRefusedException if the region cannot be searched
   */
  static RasterSetup of(RasterOptions options) {
    Mode mode = mode(options);
    if (mode == Mode.LOCAL && options.speed != null) {
      throw wrong(
          "--speed has no meaning with --local: in lock-step the simulation runs at the computer's"
              + " full speed; omit one of them");
    }
    if (options.speed != null) {
      LaneSettings.requireBetween(
          "--speed", options.speed, ScaledTime.MIN_SPEED, ScaledTime.MAX_SPEED, "");
    }
    LaneSettings lanes = LaneSettings.of(options.swath, options.spacing);
    Path file = options.world == null ? WORLD : options.world;
    WorldDescription read = WorldXml.read(file);
    WorldDescription world = options.seed == null ? read : read.withSeed(options.seed);
    GivenRegion given = region(options, mode, world, file);
    Scenario scenario =
        new Scenario(world, team(world), given.region(), lanes.swath(), lanes.spacing());
    given.requireWider(lanes.spacing());
    try {
      requireInReach(scenario);
    } catch (GoalRefusedException e) {
      throw given.withLocation(e);
    }
    double seconds = scenario.plan().length() / SLOWEST;
    return new RasterSetup(
        scenario,
        file,
        mode,
        SimulationSpeed.of(options.speed, mode, CpuSpeed::relativeToReference),
        TO_BEGIN.plusMillis((long) (1000 * seconds)));
  }

  private static GivenRegion region(
      RasterOptions options, Mode mode, WorldDescription world, Path file) {
    if (options.region != null) {
      return GivenRegion.parse(options.region);
    } else if (options.world == null && mode == Mode.PROCESSES) {
      return GivenRegion.parse(MIDDLE.toString()); // the whole field would take six minutes
    }
    return new GivenRegion(worldRegion(world), file + ": ");
  }

  private static Mode mode(RasterOptions options) {
    if (options.local && options.embedded) {
      throw wrong(
          "--local and --embedded are two ways to run a search in one virtual machine; omit one of"
              + " them");
    }
    return options.local ? Mode.LOCAL : options.embedded ? Mode.EMBEDDED : Mode.PROCESSES;
  }

  private static CommandFailure wrong(String sentence) {
    return new CommandFailure(ExitCode.USAGE_ERROR, sentence);
  }

  private static Region worldRegion(WorldDescription world) {
    LocalFrame frame = new LocalFrame(world.datum());
    List<GeoPosition> corners = new ArrayList<>();
    for (Vertex each :
        world
            .region()
            .orElseThrow(
                () ->
                    wrong(
                        "the world " + world.name() + " has no region; add one, or give --region"))
            .corners()) {
      corners.add(frame.toGeo(new LocalPosition(each.east(), each.north(), 0)));
    }
    return Region.of(corners);
  }

  /** The XML of each robot of the world, validated. */
  private static List<Path> team(WorldDescription world) {
    List<Path> team = new ArrayList<>();
    for (VehicleDescription each : world.vehicles()) {
      Path xml = TEAM.resolve(each.name() + ".xml");
      if (each.type() != VehicleType.UGV || !Files.exists(xml)) {
        throw wrong(
            each.place()
                + ": the robot "
                + each.name()
                + " cannot search: "
                + (each.type() == VehicleType.UGV
                    ? "there is no "
                        + xml
                        + " that describes its modules; write one, or rename the robot"
                    : "it is not a ground robot; remove it from the world"));
      }
      RobotDryRun.checkComplete(RobotXml.read(xml));
      team.add(xml);
    }
    if (team.isEmpty()) {
      throw wrong("the world " + world.name() + " has no robots; add atrv1 and atrv2");
    }
    return team;
  }

  private static void requireInReach(Scenario scenario) {
    LocalFrame field = new LocalFrame(scenario.world().datum());
    RasterPlan plan = scenario.plan();
    for (VehicleDescription each : scenario.world().vehicles()) {
      GeoPosition robot = field.toGeo(new LocalPosition(each.east(), each.north(), 0));
      plan.waypoints()
          .forEach(waypoint -> WaypointDistanceLimit.DEFAULT.requireWithin(robot, waypoint));
    }
  }
}
