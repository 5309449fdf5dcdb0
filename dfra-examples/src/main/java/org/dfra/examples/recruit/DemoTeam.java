package org.dfra.examples.recruit;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotDescription.GroupDescription;
import org.dfra.core.robot.ResourceCloser;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.examples.harness.DemoHost;
import org.dfra.examples.harness.DemoRobot;
import org.dfra.river.bootstrap.EmbeddedRobot;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.sim.run.Simulation;
import org.dfra.sim.run.Simulation.DeviceEndpoint;

/**
 * The robots of the demonstration. All modules of a robot except its agent are embedded in this
 * JVM; its agent's service group is a process under one phoenix for all robots.
 */
final class DemoTeam implements AutoCloseable {

  private static final Path FOLDER =
      Path.of(System.getProperty("dfra.root", "."), "config", "teams", "recruit");

  /** Name of the service group that holds a robot's agent. */
  static final String AGENT = "agent";

  private final DemoEnvironment environment;
  private final DemoHost host;
  private final List<String> locators;
  private final Map<String, RobotDescription> bodies = new LinkedHashMap<>();
  private final Map<String, RobotDescription> agents = new LinkedHashMap<>();
  private final Map<String, EmbeddedRobot> running = new LinkedHashMap<>();

  /** Reads the descriptions of the robots of that world; starts nothing. */
  DemoTeam(DemoEnvironment environment, Simulation simulation, List<String> names)
      throws IOException {
    this.environment = environment;
    this.host = environment.host("agents");
    Map<String, RobotDescription> written = new LinkedHashMap<>();
    for (String name : names) {
      Map<String, String> links =
          simulation.endpoints().stream()
              .filter(each -> each.robot().equals(name))
              .collect(Collectors.toMap(DeviceEndpoint::device, DeviceEndpoint::link));
      written.put(name, DemoRobot.describe(FOLDER.resolve(name + ".xml"), name, links));
    }
    this.locators =
        written.values().stream()
            .map(
                each ->
                    "jini://"
                        + DemoEnvironment.ADDRESS
                        + ":"
                        + each.registrar().orElseThrow().port())
            .toList();
    written.forEach(
        (name, robot) -> {
          bodies.put(name, part(robot, group -> !group.name().equals(AGENT)));
          agents.put(name, part(robot, group -> group.name().equals(AGENT)));
        });
  }

  private RobotDescription part(RobotDescription robot, Predicate<GroupDescription> which) {
    return robot
        .withLookupGroups(List.of()) // by locators only: excludes other teams on this machine
        .withRegistrars(locators)
        .withGroups(robot.groups().stream().filter(which).toList());
  }

  /** Starts the embedded modules, and then phoenix and the agents. */
  void start() throws Exception {
    for (RobotDescription each : bodies.values()) {
      EmbeddedRobot robot = new EmbeddedRobot(each, host.phoenix().state());
      running.put(each.name(), robot); // on failure, ends the parts that were started
      robot.start();
    }
    ProcessHandle unused = host.startPhoenix();
    for (RobotDescription each : agents.values()) {
      List<RobotBootstrap.ServiceReference> up = new RobotBootstrap(host.phoenix(), each).up();
      if (up.isEmpty()) {
        throw new IOException(each.source() + ": robot " + each.name() + " has no group " + AGENT);
      }
    }
  }

  /** The locators of all registrars. */
  List<String> locators() {
    return locators;
  }

  /** The embedded modules of each robot. */
  List<RobotDescription> bodies() {
    return List.copyOf(bodies.values());
  }

  /** The process of a robot's agent. */
  long process(String robot) throws IOException {
    return host.group(robot + "." + AGENT).pid();
  }

  /** Sends the process of a robot's agent a signal. */
  void signal(String name, String robot) throws IOException, InterruptedException {
    environment.signal(name, process(robot));
  }

  /** Simulates a robot's death: kills its agent, and removes its modules and its registrar. */
  void kill(String robot) throws IOException, InterruptedException {
    signal("KILL", robot);
    EmbeddedRobot body = running.remove(robot);
    if (body != null) {
      body.close();
    }
  }

  /** {@inheritDoc} The agents end with the environment. */
  @Override
  public void close() throws IOException {
    ResourceCloser ending = new ResourceCloser("the team");
    List<EmbeddedRobot> robots = new ArrayList<>(running.values());
    running.clear();
    robots.forEach(ending::close);
    ending.throwIfFailed();
  }
}
