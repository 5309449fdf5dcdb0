package org.dfra.attack;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.dfra.attack.kit.AdministrativeCallTask;
import org.dfra.attack.kit.AttackedRobot;
import org.dfra.attack.kit.FakeServices;
import org.dfra.attack.kit.ServeAttackedRobot;
import org.dfra.benchmarks.task.TaskProcess;
import org.dfra.testing.NetworkNamespaceHosts;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Robot and stranger on two computers, which are network namespaces of this machine: the robot is
 * exported at an address that others reach, and knows its own programs by its network interfaces.
 * Other attacks here use addresses of one loopback, where other rules apply.
 */
@Timeout(240)
class OtherHostAttacksIT {

  private static final Duration PATIENCE = Duration.ofSeconds(90);
  private static final int ROBOT = 0;
  private static final int STRANGER = 1;
  private static final String ADMINISTRATION = "AdministrationRefusedException";
  private static final String REGISTRATION = "RegistrationRefusedException";

  @TempDir Path folder;

  @Test
  void aStrangerOnAnotherComputerStopsTheRobotAndChangesNothing() throws Exception {
    Optional<String> refusal = NetworkNamespaceHosts.unavailableReason();
    assumeTrue(refusal.isEmpty(), () -> refusal.orElse(""));
    String here = NetworkNamespaceHosts.ADDRESSES.get(ROBOT);
    String there = NetworkNamespaceHosts.ADDRESSES.get(STRANGER);
    try (NetworkNamespaceHosts network = new NetworkNamespaceHosts();
        TaskProcess robot = robot(network, here)) {
      int port = Integer.parseInt(robot.awaitLine("ready ", PATIENCE).split(" ")[1]);
      List<String> beside = network.commandPrefix(STRANGER);
      try (TaskProcess stranger =
              AttackedRobot.attacker(beside, AdministrativeCallTask.class, here, port);
          TaskProcess fakes = AttackedRobot.attacker(beside, FakeServices.class, here, port);
          TaskProcess own =
              AttackedRobot.attacker(
                  network.commandPrefix(ROBOT), AdministrativeCallTask.class, here, port)) {
        assertThat(AttackedRobot.tried(stranger, there, "module"))
            .containsExactly(
                "parameter: " + ADMINISTRATION,
                "level: " + ADMINISTRATION,
                "outputs: " + ADMINISTRATION,
                "groups: " + ADMINISTRATION);
        assertThat(AttackedRobot.tried(stranger, there, "end-module"))
            .containsExactly("deactivate: " + ADMINISTRATION, "destroy: " + ADMINISTRATION);
        assertThat(AttackedRobot.tried(stranger, there, "registrar"))
            .containsExactly(
                "set groups: " + ADMINISTRATION,
                "add groups: " + ADMINISTRATION,
                "join: " + ADMINISTRATION);
        assertThat(AttackedRobot.tried(stranger, there, "end-registrar"))
            .containsExactly("port: " + ADMINISTRATION, "destroy: " + ADMINISTRATION);

        assertThat(outcome(fakes, there + " learn")).isEqualTo("done");
        assertThat(outcome(fakes, there + " steal")).isEqualTo(REGISTRATION);
        assertThat(outcome(fakes, there + " claim eta")).isEqualTo(REGISTRATION);
        assertThat(outcome(fakes, there + " claim theta")).as("of another robot").isEqualTo("done");

        assertThat(AttackedRobot.tried(stranger, there, "stop")).containsExactly("stop: done");
        assertThat(AttackedRobot.tried(stranger, there, "release"))
            .containsExactly("release: " + ADMINISTRATION);
        assertThat(outcome(robot, "")).isEqualTo("state true 1.0");

        assertThat(AttackedRobot.tried(own, here, "release")).containsExactly("release: done");
        assertThat(AttackedRobot.tried(own, here, "parameter"))
            .as("from the robot's own computer")
            .containsExactly("parameter: done");
        assertThat(outcome(robot, "")).isEqualTo("state false 0.2");
      }
    }
  }

  private TaskProcess robot(NetworkNamespaceHosts network, String address) throws Exception {
    return TaskProcess.start(
        network.commandPrefix(ROBOT),
        List.of("-Ddfra.root=" + System.getProperty("dfra.root")),
        ServeAttackedRobot.class,
        address,
        folder.toString());
  }

  /** The one line with which a task answers one. */
  private static String outcome(TaskProcess task, String line) throws Exception {
    task.write(line);
    return task.awaitLine("", PATIENCE);
  }
}
