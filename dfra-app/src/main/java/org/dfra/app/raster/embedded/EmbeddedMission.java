package org.dfra.app.raster.embedded;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.time.temporal.ChronoUnit;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.dfra.app.demo.stage.FieldRobot;
import org.dfra.app.demo.stage.Stage;
import org.dfra.app.figure.Figures;
import org.dfra.app.raster.Flight;
import org.dfra.app.raster.Mission;
import org.dfra.app.raster.MissionListener;
import org.dfra.app.raster.Scenario;
import org.dfra.app.raster.live.Arrival;
import org.dfra.app.raster.live.Searching;
import org.dfra.app.raster.live.ToldTime;
import org.dfra.app.raster.live.Trouble;
import org.dfra.app.raster.live.Watch;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.robot.Ending;
import org.dfra.core.time.RobotTime;
import org.dfra.core.time.ScaledTime;
import org.dfra.directory.ModuleDirectory;
import org.dfra.river.bootstrap.EmbeddedRobot;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.sim.run.SimulatedLine;
import org.dfra.sim.run.Simulation;
import org.dfra.sim.run.Simulation.Ports;

/**
 * A search in one virtual machine, with a real lookup service for each robot: modules are exported,
 * register, and find each other through lookup, drivers read the bytes of emulated devices over
 * TCP, and the robots are told what to do by proxies that were found. The seed fixes the world and
 * its noise, not when which thread has its turn.
 *
 * <p>While it runs, this virtual machine lives by the robots' time; so only one can run at a time.
 */
public final class EmbeddedMission implements Mission {

  private final Scenario scenario;
  private final double speed;
  private final Duration longest;
  private final UnaryOperator<RobotDescription> adapt;
  private final List<Trouble<EmbeddedRobot>> troubles;
  private final Figures figures;

  /**
   * The registrar of the last robot is ended on the way and comes back; those of the others are
   * ended in the midst of it, for good.
   *
   * @param scenario what is searched
   * @param speed seconds of the robots' time in a real second
   * @param longest robots' time after which a search is given up
   * @param adapt makes of each robot's description the one that is used
   * @param figures takes what is measured
   */
  public EmbeddedMission(
      Scenario scenario,
      double speed,
      Duration longest,
      UnaryOperator<RobotDescription> adapt,
      Figures figures) {
    this(scenario, speed, longest, adapt, usualTroubles(scenario.robots().size()), figures);
  }

  /** The same with other troubles. */
  EmbeddedMission(
      Scenario scenario,
      double speed,
      Duration longest,
      UnaryOperator<RobotDescription> adapt,
      List<Trouble<EmbeddedRobot>> troubles,
      Figures figures) {
    this.scenario = scenario;
    this.speed = speed;
    this.longest = longest;
    this.adapt = adapt;
    this.troubles = List.copyOf(troubles);
    this.figures = figures;
  }

  private static List<Trouble<EmbeddedRobot>> usualTroubles(int robots) {
    List<Trouble<EmbeddedRobot>> troubles = new ArrayList<>();
    for (int i = 0; i < robots - 1; i++) {
      troubles.add(new LostRegistrar(i, 0.5, LostRegistrar.FOR_GOOD));
    }
    troubles.add(new LostRegistrar(robots - 1, 0.2, 0.7));
    return troubles;
  }

  @Override
  public String mode() {
    return "embedded";
  }

  @Override
  public Flight run(MissionListener listener) throws Exception {
    try (ToldTime time = new ToldTime()) {
      Instant now = Instant.now().truncatedTo(ChronoUnit.MILLIS);
      time.tell(speed == 1 ? RobotTime.REAL : new ScaledTime(speed, now).onThisComputer());
      InstantSource clock = RobotTime.clock();
      try (Simulation simulation = Simulation.overTcp(scenario.world(), clock, Ports.ANY);
          Team team = new Team()) {
        simulation.start();
        return run(simulation, clock, team, listener);
      }
    }
  }

  /** Robots that were started; the last ends first. */
  private static final class Team implements AutoCloseable {
    private final Deque<EmbeddedRobot> robots = new ArrayDeque<>();

    EmbeddedRobot start(RobotDescription description) throws IOException {
      EmbeddedRobot robot = new EmbeddedRobot(description);
      robots.push(robot); // what of it was started ends with it, whatever becomes of the rest
      robot.start();
      return robot;
    }

    @Override
    public void close() throws IOException {
      Ending ending = new Ending("the team");
      while (!robots.isEmpty()) {
        ending.end(robots.pop());
      }
      ending.orThrow();
    }
  }

  private Flight run(
      Simulation simulation, InstantSource clock, Team team, MissionListener listener)
      throws Exception {
    List<RobotDescription> descriptions = new ArrayList<>();
    for (int i = 0; i < scenario.robots().size(); i++) {
      String name = scenario.world().vehicles().get(i).name();
      Map<String, String> links = links(simulation, name);
      descriptions.add(adapt.apply(FieldRobot.describe(scenario.robots().get(i), name, links)));
    }
    List<String> locators =
        descriptions.stream()
            .map(each -> "jini://" + Stage.ADDRESS + ":" + each.registrar().orElseThrow().port())
            .toList();
    List<EmbeddedRobot> robots = new ArrayList<>();
    for (RobotDescription each : descriptions) {
      robots.add(team.start(each.among(locators)));
    }
    try (ModuleDirectory directory = new JiniModuleDirectory(Stage.ADDRESS, List.of(), locators)) {
      List<Searching<EmbeddedRobot>> searching = new ArrayList<>();
      for (int i = 0; i < robots.size(); i++) {
        EmbeddedRobot robot = robots.get(i);
        Arrival.await(directory, robot.description());
        searching.add(Searching.of(robot.name(), robot, scenario.plan(i), directory));
      }
      SimulatedTruth truth = new SimulatedTruth(simulation.world(), clock);
      return new Watch<>(scenario, truth, clock, speed, searching, figures, listener)
          .run(troubles, longest);
    }
  }

  private static Map<String, String> links(Simulation simulation, String robot) {
    return simulation.lines().stream()
        .filter(each -> each.robot().equals(robot))
        .collect(Collectors.toMap(SimulatedLine::device, SimulatedLine::link));
  }
}
