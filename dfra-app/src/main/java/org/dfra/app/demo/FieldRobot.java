package org.dfra.app.demo;

import java.io.IOException;
import java.nio.file.Path;
import java.rmi.activation.ActivationException;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotXml;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.phoenix.GroupStatus;

/** A robot of the team in {@code config/teams/field}, on a host of its own. */
final class FieldRobot {

  private final Host host;
  private final RobotDescription robot;
  private final String locator;

  private FieldRobot(Host host, RobotDescription robot, String locator) {
    this.host = host;
    this.robot = robot;
    this.locator = locator;
  }

  /**
   * Reads the robot's description; nothing is started.
   *
   * @param front link to its front receiver
   * @param rear link to its rear receiver
   */
  static FieldRobot of(Stage stage, String name, String front, String rear) throws IOException {
    int port = Stage.freePort();
    String prefix = "DFRA_" + name.toUpperCase(Locale.ROOT);
    Map<String, String> settings =
        Map.of(
            "DFRA_HOST",
            Stage.ADDRESS,
            prefix + "_REGISTRAR_PORT",
            Integer.toString(port),
            prefix + "_GPS_FRONT_LINK",
            front,
            prefix + "_GPS_REAR_LINK",
            rear);
    Path xml =
        Path.of(System.getProperty("dfra.root", ""), "config", "teams", "field", name + ".xml");
    return new FieldRobot(
        stage.host(name),
        RobotXml.read(xml, settings::get),
        "jini://" + Stage.ADDRESS + ":" + port);
  }

  /** Starts its phoenix and everything on it. */
  List<RobotBootstrap.Service> bringUp() throws IOException, ActivationException {
    ProcessHandle unused = host.startPhoenix();
    return bootstrap().up();
  }

  String name() {
    return robot.name();
  }

  Host host() {
    return host;
  }

  RobotDescription description() {
    return robot;
  }

  /** Adds, replaces and removes its modules. */
  RobotBootstrap bootstrap() {
    return new RobotBootstrap(host.phoenix(), robot);
  }

  /** Where its own registrar is found. */
  String locator() {
    return locator;
  }

  /** The process of a service group. */
  long process(String group) throws IOException {
    GroupStatus status = host.group(robot.name() + "." + group);
    return status.pid();
  }
}
