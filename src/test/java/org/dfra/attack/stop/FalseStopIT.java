package org.dfra.attack.stop;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.drive.Commander;
import org.dfra.drive.WheeledRobot;
import org.dfra.drive.WheeledRobot.CommandResult;
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
 * stop with "stopped". A user who stops the robot from another computer, by its registrar and its
 * phoenix, halts the real wheels and reports what is true. The tests share the robot.
 */
@Timeout(180)
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class FalseStopIT {

  private static final Duration LEASE = Duration.ofSeconds(30);

  /** The real drive may register itself again at any time. */
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

  private static CommandResult stop() throws Exception {
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
   * Stops the robot while the registration of its drive is replaced by a fake's again and again.
   *
   * @return false if the fake received no order: then the real drive registered itself again right
   *     before the command read the registration. The registration after the stop is no evidence:
   *     the real drive has usually registered itself again by then
   */
  private static boolean stopsBesideTheFake(WheeledRobot robot) throws Exception {
    try (Commander unused = robot.driven(LEASE, new Velocity(1, 0))) {
      robot.awaitFullSpeed();
      int before = eta.fakes().orders();
      CommandResult result;
      Timing timing;
      try (Replacing unusedAttacker = new Replacing()) {
        StallProbe.Stopwatch running = eta.probe().stopwatch();
        result = stop();
        timing = running.stop();
      }
      int orders = eta.fakes().orders() - before;
      assertThat(result)
          .isEqualTo(new CommandResult(0, "eta/drive: stopped.\n1 effector: 1 stopped.\n"));
      timing.requireWithin("./dfra stop --all beside a fake", Duration.ofSeconds(5));
      robot.wheels().assertTheyStoodWithinHalfASecondOfTheLastCommand();
      return orders > 0;
    }
  }

  /** Puts a fake in the place of the real drive, whenever that may have registered itself again. */
  private static final class Replacing implements AutoCloseable {

    private static final long PERIOD_MILLIS = 200;

    private final ScheduledExecutorService thread = Executors.newSingleThreadScheduledExecutor();
    private final ScheduledFuture<?> attack;

    Replacing() throws RemoteException {
      eta.fakes().replace();
      attack =
          thread.scheduleWithFixedDelay(
              this::replace, PERIOD_MILLIS, PERIOD_MILLIS, TimeUnit.MILLISECONDS);
    }

    private void replace() {
      try {
        eta.fakes().replace();
      } catch (RemoteException e) {
        // a call may miss its deadline on a busy computer; the next one follows
      }
    }

    @Override
    public void close() throws InterruptedException {
      boolean wasGoingOn = !attack.isDone(); // only a failure ends it
      thread.shutdown();
      assertThat(wasGoingOn).as("the attack went on").isTrue();
      assertThat(thread.awaitTermination(30, TimeUnit.SECONDS)).as("it has ended").isTrue();
    }
  }

  @Test
  @Order(2) // it kills the drive, whose next incarnation takes the place of the fake at any time
  void whatItsPhoenixCannotConfirmIsShownAsDoubt() throws Exception {
    WheeledRobot robot = eta.robot();
    robot.signal("STOP", "eta.wheels"); // first, so that the drive cannot register itself again
    try {
      eta.fakes().replace();
      CommandResult result = stop();
      assertThat(result.status()).as(result.text()).isEqualTo(4);
      assertThat(result.text())
          .startsWith(
              "eta/drive: DOUBTFUL: its proxy says that it is stopped, and the phoenix of its robot"
                  + " does not confirm that")
          .doesNotContain("eta/drive: stopped");
    } finally {
      robot.phoenix().kill("eta.wheels");
    }
  }
}
