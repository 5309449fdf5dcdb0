package org.dfra.benchmarks.attack;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.activation.ActivationException;
import java.time.Duration;
import java.util.List;
import org.dfra.core.config.RobotXml;
import org.dfra.core.host.FreePorts;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.phoenix.GroupStatus;

/**
 * A phoenix in a separate process, with one group in another process, which has a registrar. Both
 * outlive this process; the caller must end them.
 */
final class PhoenixUnderTest {

  private static final Duration PATIENCE = Duration.ofMinutes(1);
  private static final String ROBOT = "spare";

  private final PhoenixProcess phoenix;

  /**
   * Starts no process yet.
   *
   * @param state folder of its state; created here
   * @throws IOException if there is no free port
   */
  PhoenixUnderTest(Path state) throws IOException {
    this.phoenix = new PhoenixProcess(HonestRobot.HOST, FreePorts.allocate(), -1, state);
  }

  /**
   * Starts it and waits until it answers.
   *
   * @return its process ID
   * @throws IOException if it does not start
   */
  long start() throws IOException {
    return phoenix.start(PATIENCE).pid();
  }

  /**
   * Starts its group.
   *
   * @return the group's lock file
   * @throws IOException if phoenix does not answer
   * @throws ActivationException if the group cannot be started
   */
  Path bringUp() throws IOException, ActivationException {
    Path xml =
        Files.writeString(
            phoenix.state().resolve(ROBOT + ".xml"),
            """
            <robot xmlns="urn:dfra:robot:1" name="%s" host="%s">
              <group name="lookup"><registrar port="%d" class-server-port="off"/></group>
            </robot>
            """
                .formatted(ROBOT, HonestRobot.HOST, FreePorts.allocate()));
    var unused = new RobotBootstrap(phoenix, RobotXml.read(xml)).up();
    GroupStatus group =
        phoenix.admin().groupStatus().stream()
            .filter(each -> each.name().endsWith(ROBOT + ".lookup"))
            .findFirst()
            .orElseThrow(() -> new IOException("phoenix knows no group of robot " + ROBOT));
    return phoenix.state().resolve("journal").resolve(group.name() + ".lock");
  }

  /** The TCP port of its activation system. */
  int port() {
    return phoenix.port();
  }

  /**
   * Number of its groups.
   *
   * @throws IOException if it does not answer
   */
  int groups() throws IOException {
    List<GroupStatus> all = phoenix.admin().groupStatus();
    return all.size();
  }
}
