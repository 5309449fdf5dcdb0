package org.dfra.examples.harness;

import java.io.IOException;
import java.nio.file.Path;
import java.rmi.activation.ActivationException;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotXml;
import org.dfra.core.host.FreePorts;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.phoenix.GroupStatus;

/** A robot of a team in {@code config/teams}, on its own host. */
public final class DemoRobot {

  private final DemoHost host;
  private final RobotDescription robot;
  private final String locator;

  private DemoRobot(DemoHost host, RobotDescription robot, String locator) {
    this.host = host;
    this.robot = robot;
    this.locator = locator;
  }

  /**
   * Reads the robot's description; starts nothing.
   *
   * @param team the folder of its team, under {@code config/teams}
   * @param name the robot's
   * @param links to its devices, by the device's name
   */
  public static DemoRobot of(
      DemoEnvironment environment, String team, String name, Map<String, String> links)
      throws IOException {
    Path xml = Path.of(System.getProperty("dfra.root", ""), "config", "teams", team, name + ".xml");
    return of(environment, xml, name, links, robot -> robot);
  }

  /**
   * Reads the robot's description from any path; starts nothing.
   *
   * @param xml the description, which takes its ports and links from variables as those in {@code
   *     config/teams} do
   * @param name the robot's
   * @param links to its devices, by the device's name
   * @param adapt changes the description before use
   */
  public static DemoRobot of(
      DemoEnvironment environment,
      Path xml,
      String name,
      Map<String, String> links,
      UnaryOperator<RobotDescription> adapt)
      throws IOException {
    RobotDescription robot = adapt.apply(describe(xml, name, links));
    int port = robot.registrar().orElseThrow().port();
    return new DemoRobot(
        environment.host(name), robot, "jini://" + DemoEnvironment.ADDRESS + ":" + port);
  }

  /**
   * Reads a robot's description for use beside other robots on this computer: its registrar and its
   * class server get free ports of the loopback.
   *
   * @param xml the description, which takes its ports and links from variables as those in {@code
   *     config/teams} do
   * @param name the robot's
   * @param links to its devices, by the device's name
   */
  public static RobotDescription describe(Path xml, String name, Map<String, String> links)
      throws IOException {
    String prefix = "DFRA_" + name.toUpperCase(Locale.ROOT) + "_";
    Map<String, String> settings = new HashMap<>();
    settings.put("DFRA_HOST", DemoEnvironment.ADDRESS);
    settings.put(prefix + "REGISTRAR_PORT", Integer.toString(FreePorts.allocate()));
    settings.put(prefix + "CLASS_PORT", Integer.toString(FreePorts.allocate()));
    links.forEach(
        (device, link) -> settings.put(prefix + device.toUpperCase(Locale.ROOT) + "_LINK", link));
    return RobotXml.read(xml, settings::get);
  }

  /**
   * The same robot, with further registrars for its modules, like a team without multicast.
   *
   * @param registrars of all robots of the team, as {@link #locator} returns them
   */
  public DemoRobot withRegistrars(List<String> registrars) {
    return new DemoRobot(host, robot.withRegistrars(registrars), locator);
  }

  /** Starts its phoenix and all its groups. */
  public List<RobotBootstrap.ServiceReference> bringUp() throws IOException, ActivationException {
    ProcessHandle unused = host.startPhoenix();
    return bootstrap().up();
  }

  public String name() {
    return robot.name();
  }

  public DemoHost host() {
    return host;
  }

  public RobotDescription description() {
    return robot;
  }

  /** Adds, replaces and removes its modules. */
  public RobotBootstrap bootstrap() {
    return new RobotBootstrap(host.phoenix(), robot);
  }

  /** The locator of its own registrar. */
  public String locator() {
    return locator;
  }

  /** The process of a service group. */
  public long process(String group) throws IOException {
    GroupStatus status = host.group(robot.name() + "." + group);
    return status.pid();
  }
}
