package org.dfra.attack.kit;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dfra.benchmarks.task.Task;
import org.dfra.benchmarks.task.TaskProcess;
import org.dfra.core.config.RobotXml;
import org.dfra.drive.Wheels;
import org.dfra.river.bootstrap.EmbeddedRobot;

/**
 * Robot eta in the test's own virtual machine: a registrar, and a drive of emulated wheels. An
 * attacker beside it is a process of its own.
 */
public final class AttackedRobot {

  private static final Duration PATIENCE = Duration.ofSeconds(90);

  private AttackedRobot() {}

  /**
   * The robot, which is not started yet.
   *
   * @param folder of this test alone, for its description
   * @param host the address that it is exported at
   * @param administration its {@code <administration>} element; empty for none
   */
  public static EmbeddedRobot of(Path folder, String host, String administration, Wheels wheels)
      throws IOException {
    Path xml =
        Files.writeString(
            folder.resolve("robot.xml"),
            """
            <robot xmlns="urn:dfra:robot:1" name="eta" host="%s">
              %s
              <group name="all">
                <registrar port="0" class-server-port="off"/>
                <module name="drive" properties="%s/config/modules/rflex-drive.properties">
                  <parameter name="link" value="%s"/>
                </module>
              </group>
            </robot>
            """
                .formatted(host, administration, System.getProperty("dfra.root"), wheels.url()));
    return new EmbeddedRobot(RobotXml.read(xml));
  }

  /**
   * Starts an attacker, and waits until it is ready.
   *
   * @param task what it does; it takes the registrar's host and port, and prints {@code ready}
   */
  public static TaskProcess attacker(Class<? extends Task> task, String host, int port)
      throws IOException, InterruptedException {
    return attacker(List.of(), task, host, port);
  }

  /**
   * The same on another computer.
   *
   * @param prefix what runs a command there; empty for this computer
   */
  public static TaskProcess attacker(
      List<String> prefix, Class<? extends Task> task, String host, int port)
      throws IOException, InterruptedException {
    TaskProcess started = TaskProcess.start(prefix, List.of(), task, host, Integer.toString(port));
    try {
      String unused = started.awaitLine("ready", PATIENCE);
      return started;
    } catch (IOException | InterruptedException e) {
      started.close();
      throw e;
    }
  }

  /** What each call of a verb of {@link AdministrativeCallTask} came to, from an address. */
  public static List<String> tried(TaskProcess task, String source, String verb)
      throws IOException, InterruptedException {
    task.write(source + " " + verb);
    List<String> outcomes = new ArrayList<>();
    while (true) {
      String line = task.awaitLine("", PATIENCE);
      if (line.equals(AdministrativeCallTask.END)) {
        return outcomes;
      }
      outcomes.add(line);
    }
  }
}
