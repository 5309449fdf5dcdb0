package org.dfra.attack;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import net.jini.admin.Administrable;
import net.jini.lookup.DiscoveryAdmin;
import org.dfra.attack.kit.AdministrativeCallTask;
import org.dfra.attack.kit.AttackHosts;
import org.dfra.attack.kit.AttackedRobot;
import org.dfra.benchmarks.task.TaskProcess;
import org.dfra.drive.Commander;
import org.dfra.drive.Wheels;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.LogLevel;
import org.dfra.river.bootstrap.EmbeddedRobot;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * A stranger on the network lists leases, and tries to revoke them, to change the drive's
 * parameters and log level, to end the drive and its registrar, and to release an emergency stop.
 * All of that is refused and the wheels turn on; the robot's own computer and its configured
 * operator still may. The tests share the robot and the stranger.
 */
@Timeout(120)
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class StrangerIT {

  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final String REFUSED = "AdministrationRefusedException";
  private static final double SPEED = 0.5;

  @TempDir static Path folder;

  private static AttackHosts hosts;
  private static Wheels wheels;
  private static EmbeddedRobot robot;
  private static JiniModuleDirectory directory;
  private static DriveEffector drive;
  private static TaskProcess task;

  @BeforeAll
  static void bringUp() throws Exception {
    hosts = AttackHosts.assumed();
    wheels = new Wheels();
    String administration = "<administration from=\"" + hosts.operator() + "\"/>";
    robot = AttackedRobot.of(folder, hosts.robot(), administration, wheels);
    robot.start();
    directory =
        new JiniModuleDirectory(hosts.robot(), List.of(), List.of(robot.registrar().locator()));
    drive = directory.find(DriveEffector.class, PATIENCE).orElseThrow();
    assertThat(drive.awaitReadiness(PATIENCE)).isEqualTo(Readiness.READY);
    task =
        AttackedRobot.attacker(
            AdministrativeCallTask.class, hosts.robot(), robot.registrar().port());
  }

  @BeforeEach
  void awaitRest() {
    await().atMost(PATIENCE).until(() -> wheels.standingSince() != null);
  }

  @AfterAll
  static void takeDown() throws Exception {
    try (Wheels stopped = wheels;
        EmbeddedRobot ended = robot;
        JiniModuleDirectory closed = directory;
        TaskProcess killed = task) {
      assertThat(killed == null || killed.isAlive()).as("the attacker").isTrue();
    }
  }

  /** What each call of a verb came to, from an address. */
  private List<String> tried(String source, String verb) throws Exception {
    return AttackedRobot.tried(task, source, verb);
  }

  @Test
  @Order(1)
  void changesNothingAndTheWheelsTurnOn() throws Exception {
    LogLevel level = drive.logLevel();
    try (Commander commander = new Commander(drive, PATIENCE, new Velocity(SPEED, 0))) {
      await().atMost(PATIENCE).until(() -> wheels.speed() > 0.9 * SPEED);
      assertThat(tried(hosts.attacker(), "lease"))
          .as("the commander's lease; what is listed is no lease's ID")
          .containsExactly("listed 1", "cancel: UnknownLeaseException", "revoke: " + REFUSED);
      assertThat(tried(hosts.attacker(), "module"))
          .containsExactly(
              "parameter: " + REFUSED,
              "level: " + REFUSED,
              "outputs: " + REFUSED,
              "groups: " + REFUSED);
      assertThat(tried(hosts.attacker(), "end-module"))
          .containsExactly("deactivate: " + REFUSED, "destroy: " + REFUSED);
      assertThat(tried(hosts.otherAttacker(), "registrar"))
          .containsExactly("set groups: " + REFUSED, "add groups: " + REFUSED, "join: " + REFUSED);
      assertThat(tried(hosts.otherAttacker(), "end-registrar"))
          .containsExactly("port: " + REFUSED, "destroy: " + REFUSED);
      assertThat(commander.hasGivenUp()).isFalse();
      assertThat(commander.lease().isLive()).isTrue();
      assertThat(wheels.speed()).isGreaterThan(0.9 * SPEED);
    }
    assertThat(drive.logLevel()).isEqualTo(level);
    assertThat(drive.parameters())
        .filteredOn(each -> each.name().equals("max_speed"))
        .singleElement()
        .satisfies(each -> assertThat(Double.parseDouble(each.value())).isEqualTo(1));
    Object admin = ((Administrable) robot.registrar().registrar()).getAdmin();
    assertThat(((DiscoveryAdmin) admin).getMemberGroups()).doesNotContain("elsewhere");
  }

  @Test
  @Order(2)
  void mayStopARobotButNotReleaseIt() throws Exception {
    assertThat(tried(hosts.attacker(), "stop")).containsExactly("stop: done");
    assertThat(drive.emergencyStopState().latched()).isTrue();
    assertThat(tried(hosts.attacker(), "release")).containsExactly("release: " + REFUSED);
    assertThat(drive.emergencyStopState().latched()).isTrue();
    assertThat(tried(hosts.operator(), "release")).containsExactly("release: done");
    assertThat(drive.emergencyStopState().latched()).isFalse();
    assertThat(tried(hosts.attacker(), "stop")).containsExactly("stop: done");
    assertThat(tried("127.0.0.1", "release")).containsExactly("release: done");
    assertThat(tried(hosts.robot(), "release")).containsExactly("release: done");
    assertThat(drive.emergencyStopState().latched()).isFalse();
  }

  @Test
  @Order(3) // it changes the robot
  void theOperatorMayAdminister() throws Exception {
    try (Commander commander = new Commander(drive, PATIENCE, new Velocity(SPEED, 0))) {
      assertThat(tried(hosts.operator(), "lease"))
          .containsExactly("listed 1", "cancel: UnknownLeaseException", "revoke: done");
      await().atMost(PATIENCE).until(commander::hasGivenUp);
    }
    assertThat(tried("127.0.0.1", "module"))
        .startsWith("parameter: done", "level: done", "outputs: done")
        .noneMatch(each -> each.endsWith(REFUSED));
    assertThat(tried(hosts.operator(), "registrar"))
        .containsExactly("set groups: done", "add groups: done", "join: done");
  }
}
