package org.dfra.bringup;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.dfra.app.InProcessCommand;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotXml;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.river.bootstrap.BringUpStep;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.phoenix.Phoenix;
import org.dfra.river.phoenix.PhoenixAdmin;
import org.dfra.robot.RunningPhoenix;

/**
 * A robot of thermometers that a test describes in XML and brings up, in real processes under the
 * test's phoenix. Each of its modules has a {@linkplain DeviceInUseImpl device} that only one
 * driver may have; robots of one folder share their devices.
 */
final class ThermometerRobot {

  static final String HOST = "127.0.0.1";

  private final String name;
  private final RunningPhoenix phoenix;
  private final Path folder;
  private final String common;
  private final List<String> steps = new ArrayList<>();

  /**
   * @param folder of its XML and its devices
   * @param common the groups that each of its descriptions begins with, as XML; may be empty
   */
  ThermometerRobot(String name, RunningPhoenix phoenix, Path folder, String common) {
    this.name = name;
    this.phoenix = phoenix;
    this.folder = folder;
    this.common = common;
  }

  static String group(String name, String content) {
    return "<group name=\"" + name + "\">\n" + content + "</group>\n";
  }

  static String registrar(int port) {
    return "<registrar port=\"" + port + "\" class-server-port=\"off\"/>\n";
  }

  /** A group with module {@code drive} alone. */
  String drive(int celsius, String group) {
    return group(group, module("drive", celsius));
  }

  /** A group with module {@code eye} alone. */
  String eye(int celsius, String group) {
    return group(group, module("eye", celsius));
  }

  /** A module whose device has its name. */
  String module(String name, int celsius) {
    return module(name, celsius, name);
  }

  String module(String name, int celsius, String device) {
    return """
    <module name="%s" server="%s" proxy="%s" implementation="%s">
      <parameter name="celsius" value="%d"/>
      <parameter name="device" value="%s"/>
    </module>
    """
        .formatted(
            name,
            ThermometerServer.class.getName(),
            ThermometerProxy.class.getName(),
            DeviceInUseImpl.class.getName(),
            celsius,
            device(device));
  }

  /** The file that exists while a driver has a device. */
  Path device(String name) {
    return folder.resolve(name + ".device");
  }

  /** Writes its description, with these groups after the common ones. */
  Path xml(String groups) throws IOException {
    return Files.writeString(
        folder.resolve(name + ".xml"),
        "<robot xmlns=\"urn:dfra:robot:1\" name=\"%s\" host=\"%s\">\n%s</robot>\n"
            .formatted(name, HOST, common + groups));
  }

  /** The same, as it is read again. */
  RobotDescription described(String groups) throws IOException {
    return RobotXml.read(xml(groups));
  }

  /** Brings it up with these groups after the common ones, and adds to its {@link #steps}. */
  void up(String groups) throws Exception {
    RobotDescription description = described(groups);
    try {
      List<RobotBootstrap.ServiceReference> unused =
          new RobotBootstrap(phoenix.process(), description).up(step -> steps.add(inWords(step)));
    } finally {
      phoenix.note();
    }
  }

  private static String inWords(BringUpStep step) {
    return (step.kind() + " " + step.name() + " " + step.group() + " " + step.detail()).strip();
  }

  /** What was done to bring it up, in order; a test may clear it. */
  List<String> steps() {
    return steps;
  }

  /** What {@code ./dfra} answers, which is run here with the robot's phoenix. */
  String dfra(String... words) {
    String state = "--state=" + phoenix.process().state();
    InProcessCommand run =
        InProcessCommand.run(
            Stream.concat(Stream.of(words), Stream.of(state)).toArray(String[]::new));
    phoenix.note();
    assertThat(run.code()).as(run.out() + run.err()).isZero();
    assertThat(run.out() + run.err()).as("in a pipe").doesNotContainPattern("[\\p{Cntrl}&&[^\\n]]");
    return run.out();
  }

  /**
   * Has phoenix forget the objects of its groups, whose processes go on: so an interrupted {@code
   * ./dfra down} leaves them.
   *
   * @param groups how the groups' names begin
   */
  @SuppressWarnings("unchecked") // as phoenix declares it
  void unregister(String groups) throws Exception {
    PhoenixAdmin admin = phoenix.process().admin();
    Map<ActivationGroupID, ActivationGroupDesc> registered = admin.getActivationGroups();
    for (var group : registered.entrySet()) {
      String path = group.getValue().getPropertyOverrides().getProperty(Phoenix.GROUP_NAME);
      if (path.startsWith(name + "." + groups)) {
        for (Object object : admin.getActivatableObjects(group.getKey()).keySet()) {
          phoenix.process().system().unregisterObject((ActivationID) object);
        }
      }
    }
  }
}
