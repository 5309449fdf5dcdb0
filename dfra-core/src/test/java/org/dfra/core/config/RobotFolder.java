package org.dfra.core.config;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** A folder with a robot's XML and one module's properties, as the tests want them. */
final class RobotFolder {

  static final String CLASSES =
      "server=org.dfra.river.server.sensor.GPSServer\n"
          + "proxy=org.dfra.river.proxy.sensor.GPSProxy\n"
          + "implementation=org.dfra.drivers.gps.m12.M12PlusImpl\n";

  final Map<String, String> variables = new HashMap<>();

  private final Path folder;

  RobotFolder(Path folder) {
    this.folder = folder;
    properties(CLASSES);
  }

  /** Writes {@code gps.properties}. */
  RobotFolder properties(String text) {
    write("gps.properties", text);
    return this;
  }

  /** Writes {@code robot.xml}, its root open in line 1, the given lines from line 2. */
  RobotFolder xml(String... lines) {
    return document(
        "<robot xmlns=\"urn:dfra:robot:1\" name=\"atrv1\">\n"
            + String.join("\n", lines)
            + "\n</robot>\n");
  }

  /** Writes {@code robot.xml}. */
  RobotFolder document(String text) {
    write("robot.xml", text);
    return this;
  }

  /** Writes {@code robot.xml} with one module from line 3, the given lines in it from line 4. */
  RobotFolder module(String... lines) {
    return xml(
        "<group name=\"gps\">",
        "<module name=\"gps_front\" properties=\"gps.properties\">",
        String.join("\n", lines),
        "</module>",
        "</group>");
  }

  Path path(String name) {
    return folder.resolve(name);
  }

  RobotDescription read() {
    return RobotXml.read(path("robot.xml"), variables::get);
  }

  ModuleDescription readModule() {
    return read().modules().get(0);
  }

  /** The complaint's lines, without the folder's path. */
  List<String> complaints() {
    ConfigurationException complaint =
        catchThrowableOfType(ConfigurationException.class, this::read);
    assertThat(complaint).as("a robot that cannot be used was read").isNotNull();
    return complaint.getMessage().lines().map(this::withoutFolder).toList();
  }

  private String withoutFolder(String line) {
    return line.replace(folder + "/", "");
  }

  void write(String name, String text) {
    try {
      Files.writeString(path(name), text);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }
}
