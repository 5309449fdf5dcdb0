package org.dfra.examples.mission.embedded;

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
import org.dfra.core.config.RobotDescription;
import org.dfra.core.robot.ResourceCloser;
import org.dfra.core.time.RobotTime;
import org.dfra.core.time.ScaledTime;
import org.dfra.directory.ModuleDirectory;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.examples.harness.DemoRobot;
import org.dfra.examples.mission.Mission;
import org.dfra.examples.mission.MissionProgressListener;
import org.dfra.examples.mission.MissionResult;
import org.dfra.examples.mission.Scenario;
import org.dfra.examples.mission.monitor.AnnouncedTime;
import org.dfra.examples.mission.monitor.MissionMonitor;
import org.dfra.examples.mission.monitor.MissionMonitor.InjectedFault;
import org.dfra.examples.mission.monitor.MissionMonitor.TruthSource;
import org.dfra.examples.mission.monitor.RobotStartup;
import org.dfra.examples.mission.monitor.SearchingRobot;
import org.dfra.examples.mission.monitor.TrueTrajectory;
import org.dfra.report.measurement.RunMeasurements;
import org.dfra.river.bootstrap.EmbeddedRobot;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.sim.run.Simulation;
import org.dfra.sim.run.Simulation.DeviceEndpoint;
import org.dfra.sim.run.Simulation.PortPolicy;
import org.dfra.sim.world.GroundTruth;
import org.dfra.sim.world.GroundTruth.Collision;
import org.dfra.sim.world.World;

/**
 * A search in one JVM, with a real lookup service for each robot: modules are exported, register,
 * and find each other through lookup, drivers read the bytes of emulated devices over TCP, and the
 * robots are commanded through discovered proxies. The seed determines the world and its noise, but
 * not the scheduling of threads.
 *
 * <p>While it runs, this JVM uses the robots' time; so only one can run at a time.
 */
public final class EmbeddedMission implements Mission {

  private final Scenario scenario;
  private final double speed;
  private final Duration longest;
  private final UnaryOperator<RobotDescription> adapt;
  private final List<InjectedFault<EmbeddedRobot>> faults;
  private final RunMeasurements figures;

  /**
   * The registrar of the last robot is stopped during the search and restarted; those of the others
   * are stopped in the middle of it, permanently.
   *
   * @param scenario the search
   * @param speed seconds of the robots' time per real second
   * @param longest timeout of a search, robots' time
   * @param adapt changes each robot's description before use
   * @param figures receives the measurements
   */
  public EmbeddedMission(
      Scenario scenario,
      double speed,
      Duration longest,
      UnaryOperator<RobotDescription> adapt,
      RunMeasurements figures) {
    this(scenario, speed, longest, adapt, defaultFaults(scenario.robots().size()), figures);
  }

  /** The same with other faults. */
  EmbeddedMission(
      Scenario scenario,
      double speed,
      Duration longest,
      UnaryOperator<RobotDescription> adapt,
      List<InjectedFault<EmbeddedRobot>> faults,
      RunMeasurements figures) {
    this.scenario = scenario;
    this.speed = speed;
    this.longest = longest;
    this.adapt = adapt;
    this.faults = List.copyOf(faults);
    this.figures = figures;
  }

  private static List<InjectedFault<EmbeddedRobot>> defaultFaults(int robots) {
    List<InjectedFault<EmbeddedRobot>> faults = new ArrayList<>();
    for (int i = 0; i < robots - 1; i++) {
      faults.add(new RegistrarOutage(i, 0.5, RegistrarOutage.NEVER));
    }
    faults.add(new RegistrarOutage(robots - 1, 0.2, 0.7));
    return faults;
  }

  @Override
  public String mode() {
    return "embedded";
  }

  @Override
  public MissionResult run(MissionProgressListener listener) throws Exception {
    try (AnnouncedTime time = new AnnouncedTime()) {
      Instant now = Instant.now().truncatedTo(ChronoUnit.MILLIS);
      time.set(speed == 1 ? RobotTime.REAL : new ScaledTime(speed, now).toHostText());
      InstantSource clock = RobotTime.clock();
      try (Simulation simulation =
              Simulation.overTcp(scenario.world(), clock, PortPolicy.EPHEMERAL);
          RunningRobots team = new RunningRobots()) {
        simulation.start();
        return run(simulation, clock, team, listener);
      }
    }
  }

  /** Running robots; the last ends first. */
  private static final class RunningRobots implements AutoCloseable {
    private final Deque<EmbeddedRobot> robots = new ArrayDeque<>();

    EmbeddedRobot start(RobotDescription description) throws IOException {
      EmbeddedRobot robot = new EmbeddedRobot(description);
      robots.push(robot); // ends the started parts, whatever happens to the others
      robot.start();
      return robot;
    }

    @Override
    public void close() throws IOException {
      ResourceCloser ending = new ResourceCloser("the team");
      while (!robots.isEmpty()) {
        ending.close(robots.pop());
      }
      ending.throwIfFailed();
    }
  }

  private MissionResult run(
      Simulation simulation,
      InstantSource clock,
      RunningRobots team,
      MissionProgressListener listener)
      throws Exception {
    List<RobotDescription> descriptions = new ArrayList<>();
    for (int i = 0; i < scenario.robots().size(); i++) {
      String name = scenario.world().vehicles().get(i).name();
      Map<String, String> links = links(simulation, name);
      descriptions.add(adapt.apply(DemoRobot.describe(scenario.robots().get(i), name, links)));
    }
    List<String> locators =
        descriptions.stream()
            .map(
                each ->
                    "jini://"
                        + DemoEnvironment.ADDRESS
                        + ":"
                        + each.registrar().orElseThrow().port())
            .toList();
    List<EmbeddedRobot> robots = new ArrayList<>();
    for (RobotDescription each : descriptions) {
      robots.add(team.start(each.withRegistrars(locators)));
    }
    try (ModuleDirectory directory =
        new JiniModuleDirectory(DemoEnvironment.ADDRESS, List.of(), locators)) {
      List<SearchingRobot<EmbeddedRobot>> searching = new ArrayList<>();
      for (int i = 0; i < robots.size(); i++) {
        EmbeddedRobot robot = robots.get(i);
        RobotStartup.awaitReady(directory, robot.description());
        searching.add(SearchingRobot.connect(robot.name(), robot, scenario.plan(i), directory));
      }
      SimulatedTruth truth = new SimulatedTruth(simulation.world(), clock);
      return new MissionMonitor<>(scenario, truth, clock, speed, searching, figures, listener)
          .run(faults, longest);
    }
  }

  private static Map<String, String> links(Simulation simulation, String robot) {
    return simulation.endpoints().stream()
        .filter(each -> each.robot().equals(robot))
        .collect(Collectors.toMap(DeviceEndpoint::device, DeviceEndpoint::link));
  }

  /**
   * The true poses of robots, sampled from a simulated world in this JVM a hundred times a second
   * of its time. Confined to one thread.
   */
  private static final class SimulatedTruth implements TruthSource {

    private static final Duration PERIOD = Duration.ofMillis(10);

    private final GroundTruth truth;
    private final InstantSource clock;
    private Instant next;

    /**
     * @param clock the world's clock
     */
    SimulatedTruth(World world, InstantSource clock) {
      this.truth = world.groundTruth();
      this.clock = clock;
      this.next = clock.instant();
    }

    /** Does not sample future times: that would delay the devices. */
    @Override
    public void readNew(TrueTrajectory way) {
      Instant now = clock.instant();
      for (; !next.isAfter(now); next = next.plus(PERIOD)) {
        truth.poses(next).forEach(way::add);
      }
    }

    @Override
    public List<Collision> collisions() {
      return truth.collisions();
    }
  }
}
