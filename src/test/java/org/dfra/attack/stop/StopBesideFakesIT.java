package org.dfra.attack.stop;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Objects;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.drive.Commander;
import org.dfra.drive.WheeledRobot;
import org.dfra.drive.WheeledRobot.CommandResult;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * A robot that drives is stopped in time though its registrar lists 3 000 fake drives (in the
 * everyday tier 300, more than it takes of one stranger).
 */
@Timeout(240)
class StopBesideFakesIT {

  private static final int FAKES = Boolean.getBoolean("dfra.full") ? 3000 : 300;
  private static final Duration LEASE = Duration.ofSeconds(30);

  /** From typing the command, which starts a Java virtual machine. */
  private static final Duration STOPPED = Duration.ofSeconds(3);

  @TempDir static Path folder;

  private static RobotBesideFakes eta;

  @BeforeAll
  static void bringUp() throws Exception {
    eta = RobotBesideFakes.start(folder);
    for (int i = 0; i < FAKES; i++) {
      Object unused = eta.fakes().add("fake" + i);
    }
  }

  @AfterAll
  static void takeDown() throws Exception {
    if (eta != null) {
      eta.close();
    }
  }

  private static CommandResult stopInTime(String what, String... words) throws Exception {
    WheeledRobot robot = eta.robot();
    if (robot.drive().emergencyStopState().latched()) {
      assertThat(robot.drive().releaseEmergencyStop("the next test").latched()).isFalse();
    }
    try (Commander unused = new Commander(robot.drive(), LEASE, new Velocity(1, 0))) {
      robot.awaitFullSpeed();
      StallProbe.Stopwatch running = eta.probe().stopwatch();
      Instant typed = Instant.now();
      CommandResult result = eta.stop(words);
      Timing timing = running.stop();
      Instant ordered =
          Objects.requireNonNull(robot.drive().emergencyStopState().since(), result.text());
      timing.ofPart(Duration.between(typed, ordered)).requireWithin(what, STOPPED);
      robot.wheels().assertTheyStoodWithinHalfASecondOfTheLastCommand();
      return result;
    }
  }

  @Test
  void itsPhoenixStopsItBeforeAnythingIsRead() throws Exception {
    CommandResult result =
        stopInTime("./dfra stop --all beside fakes", "--all", eta.robot().phoenixOption());
    assertThat(result.text()).contains("eta/drive: stopped.\n");
  }

  @Test
  void itIsReadFirstWhereItIsNamed() throws Exception {
    CommandResult result = stopInTime("./dfra stop eta beside fakes", "eta");
    assertThat(result)
        .as("no phoenix is known there, so its own word counts")
        .isEqualTo(new CommandResult(0, "eta/drive: stopped.\n1 effector: 1 stopped.\n"));
  }
}
