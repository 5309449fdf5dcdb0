package org.dfra.attack.stop;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Objects;
import org.dfra.attack.kit.SilentPeer;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.drive.Commander;
import org.dfra.drive.WheeledRobot;
import org.dfra.drive.WheeledRobot.CommandResult;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;

/**
 * A robot that drives is stopped in time by its proxy alone, no phoenix being known, though its
 * registrar lists 3 000 drives that take connections and never answer.
 */
@Timeout(240)
@EnabledIfSystemProperty(
    named = "dfra.full",
    matches = "true",
    disabledReason = "it registers 3 000 fakes; FairCallSchedulerTest shows the order of calls")
class StopBesideSilentFakesIT {

  private static final int FAKES = 3000;
  private static final Duration LEASE = Duration.ofSeconds(30);

  /** From typing the command, which starts a Java virtual machine. */
  private static final Duration STOPPED = Duration.ofSeconds(3);

  @TempDir Path folder;

  @Test
  void itsProxyIsCalledAmongTheFirst() throws Exception {
    try (RobotBesideFakes eta = RobotBesideFakes.start(folder);
        SilentPeer silent = new SilentPeer("127.0.0.3", 16)) {
      for (int i = 0; i < FAKES; i++) {
        Object unused = eta.fakes().addSilent("fake" + i, silent);
      }
      WheeledRobot robot = eta.robot();
      try (Commander unused = new Commander(robot.drive(), LEASE, new Velocity(1, 0))) {
        robot.awaitFullSpeed();
        StallProbe.Stopwatch running = eta.probe().stopwatch();
        Instant typed = Instant.now();
        CommandResult result = eta.stop("--all");
        Timing timing = running.stop();
        Instant ordered =
            Objects.requireNonNull(robot.drive().emergencyStopState().since(), result.text());
        System.out.println("ordered " + Duration.between(typed, ordered) + " after it was typed");
        timing
            .ofPart(Duration.between(typed, ordered))
            .requireWithin("./dfra stop --all beside silent fakes", STOPPED);
        robot.wheels().assertTheyStoodWithinHalfASecondOfTheLastCommand();
        assertThat(result.text()).contains("eta/drive: stopped.\n");
        assertThat(result.status()).as("the fakes did not stop").isNotZero();
      }
    }
  }
}
