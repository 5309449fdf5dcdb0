package org.dfra.examples.mission.process;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.UnaryOperator;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.time.RobotTime;
import org.dfra.directory.ModuleDirectory;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.examples.harness.DemoRobot;
import org.dfra.examples.harness.SimulationProcess;
import org.dfra.examples.mission.Mission;
import org.dfra.examples.mission.MissionProgressListener;
import org.dfra.examples.mission.MissionResult;
import org.dfra.examples.mission.Scenario;
import org.dfra.examples.mission.monitor.AnnouncedTime;
import org.dfra.examples.mission.monitor.MissionMonitor;
import org.dfra.examples.mission.monitor.MissionMonitor.InjectedFault;
import org.dfra.examples.mission.monitor.RobotStartup;
import org.dfra.examples.mission.monitor.SearchingRobot;
import org.dfra.report.measurement.RunMeasurements;
import org.dfra.report.terminal.ConsoleMessages;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.sim.world.description.VehicleDescription;
import org.jspecify.annotations.Nullable;

/**
 * A search in real processes: one for the world, and for each robot phoenix, its registrar and its
 * service groups. Robots are discovered through lookup and commanded through their proxies. The
 * seed determines the world and its noise, but not the scheduling of processes.
 *
 * <p>While it runs, this JVM passes the robots' time to the processes that it starts, by {@link
 * RobotTime#PROPERTY}; so only one can run at a time.
 */
public final class ProcessMission implements Mission {

  private final Scenario scenario;
  private final Path world;
  private final double speed;
  private final Duration longest;
  private final UnaryOperator<RobotDescription> adapt;
  private final List<InjectedFault<DemoRobot>> faults;
  private final RunMeasurements figures;

  /**
   * @param scenario the search; its world's seed counts, the rest of that world is as written
   * @param world the file that describes the scenario's world
   * @param speed seconds of the robots' time per real second
   * @param longest timeout of a search, robots' time
   * @param adapt changes each robot's description before use
   * @param troubled whether processes are killed during the search; that needs two robots
   * @param figures receives the measurements
   */
  public ProcessMission(
      Scenario scenario,
      Path world,
      double speed,
      Duration longest,
      UnaryOperator<RobotDescription> adapt,
      boolean troubled,
      RunMeasurements figures) {
    this(scenario, world, speed, longest, adapt, troubled ? defaultFaults() : List.of(), figures);
    if (troubled && scenario.robots().size() < 2) {
      throw new IllegalArgumentException(
          "the demonstration kills processes of two robots, but the world has "
              + scenario.robots().size());
    }
  }

  /** The same with other faults. */
  ProcessMission(
      Scenario scenario,
      Path world,
      double speed,
      Duration longest,
      UnaryOperator<RobotDescription> adapt,
      List<InjectedFault<DemoRobot>> faults,
      RunMeasurements figures) {
    this.scenario = scenario;
    this.world = world;
    this.speed = speed;
    this.longest = longest;
    this.adapt = adapt;
    this.faults = List.copyOf(faults);
    this.figures = figures;
  }

  private static List<InjectedFault<DemoRobot>> defaultFaults() {
    InjectedFault<DemoRobot> receiver = new ReceiverProcessKill(0, "gps_front", 0.1);
    InjectedFault<DemoRobot> navigation =
        new ProcessKillOnLane(0, "navigation", 0.3, true, receiver);
    InjectedFault<DemoRobot> drive = new ProcessKillOnLane(0, "drive", 0.6, false, navigation);
    return List.of(
        receiver, navigation, drive, new PhoenixOutage(1, 0.2, 0.7, InjectedFault.none()));
  }

  @Override
  public String mode() {
    return "processes";
  }

  @Override
  public MissionResult run(MissionProgressListener listener) throws Exception {
    try (AnnouncedTime time = new AnnouncedTime();
        DemoEnvironment environment = new DemoEnvironment()) {
      Thread end = new Thread(() -> closeAtTheEnd(environment), "mission-end");
      Runtime.getRuntime().addShutdownHook(end);
      try {
        MissionResult flight = run(environment, time, listener);
        Runtime.getRuntime().removeShutdownHook(end);
        return flight;
      } catch (InterruptedException e) {
        throw e;
      } catch (Exception e) { // whatever the failure, the processes' logs are in the folder
        environment.keepFolder();
        String why = e instanceof IOException ? String.valueOf(e.getMessage()) : e.toString();
        throw new IOException(why + "; the logs are in " + environment.folder(), e);
      }
    }
  }

  private static void closeAtTheEnd(DemoEnvironment environment) {
    try {
      environment.close();
    } catch (IOException e) {
      System.err.println(ConsoleMessages.prefixed(String.valueOf(e.getMessage())));
    }
  }

  private MissionResult run(
      DemoEnvironment environment, AnnouncedTime time, MissionProgressListener listener)
      throws Exception {
    SimulationProcess field =
        SimulationProcess.start(
            environment, world, List.of("--seed=" + scenario.world().seed(), "--speed=" + speed));
    time.set(field.startMessage().dfraTime());
    List<DemoRobot> robots = bringUp(environment, field);
    List<String> locators = robots.stream().map(DemoRobot::locator).toList();
    try (ModuleDirectory directory =
            new JiniModuleDirectory(DemoEnvironment.ADDRESS, List.of(), locators);
        TruthFile truth = new TruthFile(field)) {
      List<SearchingRobot<DemoRobot>> searching = new ArrayList<>();
      for (int i = 0; i < robots.size(); i++) {
        DemoRobot robot = robots.get(i);
        RobotStartup.awaitReady(directory, robot.description());
        searching.add(SearchingRobot.connect(robot.name(), robot, scenario.plan(i), directory));
      }
      MissionResult flight =
          new MissionMonitor<>(
                  scenario, truth, RobotTime.clock(), speed, searching, figures, listener)
              .run(faults, longest);
      environment.shutDown();
      return flight;
    }
  }

  private List<DemoRobot> bringUp(DemoEnvironment environment, SimulationProcess field)
      throws Exception {
    List<DemoRobot> strangers = new ArrayList<>();
    for (int i = 0; i < scenario.robots().size(); i++) {
      VehicleDescription vehicle = scenario.world().vehicles().get(i);
      Map<String, String> links = field.links(vehicle.name());
      strangers.add(
          DemoRobot.of(environment, scenario.robots().get(i), vehicle.name(), links, adapt));
    }
    List<String> registrars = strangers.stream().map(DemoRobot::locator).toList();
    List<DemoRobot> robots =
        strangers.stream().map(each -> each.withRegistrars(registrars)).toList();
    ExecutorService threads = Executors.newFixedThreadPool(robots.size());
    try {
      List<Callable<List<RobotBootstrap.ServiceReference>>> tasks = new ArrayList<>();
      robots.forEach(each -> tasks.add(each::bringUp));
      for (Future<List<RobotBootstrap.ServiceReference>> each : threads.invokeAll(tasks)) {
        List<RobotBootstrap.ServiceReference> unused = each.get();
      }
    } catch (ExecutionException e) {
      @Nullable Throwable why = e.getCause();
      throw new IOException("a robot did not start: " + (why == null ? e : why).getMessage(), why);
    } finally {
      threads.shutdownNow();
    }
    for (DemoRobot each : robots) {
      var unused = each.host().groups(); // their processes are ended whatever happens to phoenix
    }
    return robots;
  }
}
