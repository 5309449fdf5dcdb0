package org.dfra.attack;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.drive.Commander;
import org.dfra.drive.WheeledRobot;
import org.dfra.drive.WheeledRobot.Said;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.EmergencyStopState;
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
 * A fake proxy is registered under the drive's service ID in its own registrar, and answers every
 * stop with "stopped". Whoever stops the robot from another computer, by its registrar and its
 * phoenix, halts the real wheels and reports what is true. The tests share the robot.
 */
@Timeout(180)
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class FalseStopIT {

  private static final Duration LEASE = Duration.ofSeconds(30);

  /** The real drive may register itself anew at any time. */
  private static final int ATTEMPTS = 5;

  @TempDir static Path folder;

  private static RobotBesideFakes eta;

  @BeforeAll
  static void bringUp() throws Exception {
    eta = RobotBesideFakes.start(folder);
  }

  @BeforeEach
  void reset() throws Exception {
    eta.robot().reset();
  }

  @AfterAll
  static void takeDown() throws Exception {
    if (eta != null) {
      eta.close();
    }
  }

  private static Said stop() throws Exception {
    return eta.stop("--all", eta.robot().phoenixOption());
  }

  @Test
  @Order(1)
  void theRealWheelsStopAndItsPhoenixConfirmsIt() throws Exception {
    WheeledRobot robot = eta.robot();
    for (int attempt = 1; !stopsBesideTheFake(robot); attempt++) {
      assertThat(attempt).as("attempts in which the fake received no order").isLessThan(ATTEMPTS);
      robot.reset();
    }
    EmergencyStopState state = robot.drive().emergencyStopState();
    assertThat(state.latched()).isTrue();
    assertThat(state.requester()).as("not by the fake").contains(" at " + WheeledRobot.HOST);
  }

  /**
   * Stops the robot after the registration of its drive was replaced by a fake's.
   *
   * @return false if the fake received no order: then the real drive registered itself anew before
   *     the command read the registration. The registration after the stop is no evidence: the real
   *     drive has usually registered itself anew by then
   */
  private static boolean stopsBesideTheFake(WheeledRobot robot) throws Exception {
    try (Commander unused = robot.driven(LEASE, new Velocity(1, 0))) {
      robot.awaitFullSpeed();
      eta.fakes().replace();
      int before = eta.fakes().orders();
      StallProbe.Stopwatch running = eta.probe().stopwatch();
      Said said = stop();
      Timing timing = running.stop();
      int orders = eta.fakes().orders() - before;
      assertThat(said).isEqualTo(new Said(0, "eta/drive: stopped.\n1 effector: 1 stopped.\n"));
      timing.requireWithin("./dfra stop --all beside a fake", Duration.ofSeconds(5));
      robot.wheels().assertTheyStoodWithinHalfASecondOfTheLastCommand();
      return orders > 0;
    }
  }

  @Test
  @Order(2) // it kills the drive, whose next incarnation takes the place of the fake at any time
  void whatItsPhoenixCannotConfirmIsShownAsDoubt() throws Exception {
    WheeledRobot robot = eta.robot();
    robot.signal("STOP", "eta.wheels"); // first, so that the drive cannot register itself anew
    try {
      eta.fakes().replace();
      Said said = stop();
      assertThat(said.status()).as(said.text()).isEqualTo(4);
      assertThat(said.text())
          .startsWith(
              "eta/drive: DOUBTFUL: its proxy says that it is stopped, and the phoenix of its robot"
                  + " does not confirm that")
          .doesNotContain("eta/drive: stopped");
    } finally {
      robot.phoenix().kill("eta.wheels");
    }
  }
}
