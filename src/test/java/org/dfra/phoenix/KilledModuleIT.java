package org.dfra.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.awaitility.core.ConditionFactory;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.drive.Commander;
import org.dfra.drive.WheeledRobot;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.lease.ModuleLease;
import org.dfra.module.Identification;
import org.dfra.river.phoenix.GroupStatus;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * The process of a robot's wheels is killed with -9 again and again: it is back each time, the
 * wheels stood in between, nobody's command counts any more, and an emergency stop is kept.
 *
 * <p>Short: five kills, at which the restart policy holds off a group that never worked. {@code
 * dfra.full}: every 5 s for two minutes. {@code dfra.soak}: every 5 s for an hour; the figures are
 * appended to {@code benchmarks/killed-module.csv}, whether all went well or not.
 */
@Timeout(value = 3, unit = TimeUnit.HOURS)
class KilledModuleIT {

  private static final boolean SOAK = Boolean.getBoolean("dfra.soak");
  private static final boolean FULL = SOAK || Boolean.getBoolean("dfra.full");
  private static final Duration PERIOD = Duration.ofSeconds(5);
  private static final int KILLS = SOAK ? 720 : FULL ? 24 : 5;

  /** Between looks at it while it comes back, each of which costs processor time. */
  private static final Duration POLL = Duration.ofMillis(FULL ? 25 : 100);

  /** Ready for longer than 2 s, which phoenix counts from the report of readiness. */
  private static final Duration WORK = Duration.ofMillis(2500);

  private static final Duration TARGET = Duration.ofSeconds(2);
  private static final Duration HOLD_OFF = Duration.ofSeconds(30);
  private static final Duration PATIENCE = Duration.ofSeconds(60);
  private static final String GROUP = "eta.wheels";
  private static final Path RECORD =
      Path.of(System.getProperty("dfra.root", ""), "benchmarks", "killed-module.csv");

  @TempDir Path folder;

  private final StallProbe probe = StallProbe.start();
  private final KillFigures figures = new KillFigures(TARGET);
  private WheeledRobot robot;
  private DriveEffector drive;

  @BeforeEach
  void bringUp() throws Exception {
    robot = WheeledRobot.start(folder, "drive");
    drive = robot.drive();
  }

  @AfterEach
  void takeDown() throws Exception {
    probe.close();
    if (robot != null) {
      robot.close();
    }
  }

  private static ConditionFactory patiently(String what) {
    return await(what)
        .atMost(PATIENCE)
        .pollInterval(POLL)
        .ignoreExceptionsInstanceOf(RemoteException.class);
  }

  @Test
  void isBackInTimeHoweverOftenItIsKilled() throws Exception {
    Identification identity = drive.identification();
    long next = System.nanoTime();
    try (ModuleLease lease = drive.acquireLease(Duration.ofSeconds(10))) { // a client that stays
      for (int kill = 1; kill <= KILLS; kill++) {
        next = Math.max(next + (FULL ? PERIOD.toNanos() : 0), System.nanoTime() + WORK.toNanos());
        if (kill % 2 == 0) {
          killedWhileStopped(next);
        } else {
          killedWhileItDrives(next);
        }
        assertThat(drive.identification()).isEqualTo(identity);
        figures.kept();
      }
      patiently("the client's lease").until(lease::isLive);
    } finally {
      print();
      if (SOAK) {
        figures.record(RECORD);
      }
    }
    GroupStatus status = robot.phoenix().group(GROUP);
    assertThat(status.heldOffUntil()).isNull();
    assertThat(status.totalCrashes()).as("one crash for each kill").isEqualTo(KILLS);
    assertThat(figures.quantile(1).took()).as("longest").isLessThan(HOLD_OFF);
    if (FULL) {
      figures
          .quantile(0.95)
          .requireWithin("being back after kill -9 (p95 of " + KILLS + ")", TARGET);
    }
  }

  private void killedWhileItDrives(long at) throws Exception {
    try (Commander commander = new Commander(drive, Duration.ofSeconds(10), new Velocity(1, 0))) {
      robot.awaitFullSpeed();
      kill(at);
      robot.wheels().assertTheyStoodWithinHalfASecondOfTheLastCommand();
      assertThatThrownBy(() -> drive.execute(commander.lease().key(), new Velocity(1, 0)))
          .as("a command from before the kill")
          .isInstanceOf(CommandRefusedException.class);
    }
    assertTheyStand("before anybody commands");
  }

  private void killedWhileStopped(long at) throws Exception {
    patiently("stop").until(() -> drive.emergencyStop("the test").latched());
    EmergencyStopState stop = drive.emergencyStopState();
    kill(at);
    EmergencyStopState kept = drive.emergencyStopState();
    assertThat(kept.latched()).as("emergency stop after the kill").isTrue();
    assertThat(List.of(kept.requester(), kept.since()))
        .containsExactly(stop.requester(), stop.since());
    patiently("release").until(() -> !drive.releaseEmergencyStop("the test").latched());
    assertTheyStand("after the release");
  }

  private void assertTheyStand(String when) {
    assertThat(robot.wheels().speed()).as("speed %s", when).isLessThan(1e-3);
  }

  /** Kills it at that time, and waits until it is of use again. */
  private void kill(long at) throws Exception {
    await().atMost(PATIENCE).until(() -> System.nanoTime() - at > 0);
    long pid = robot.phoenix().group(GROUP).pid();
    StallProbe.Stopwatch killed = probe.stopwatch();
    figures.killed();
    robot.phoenix().kill(GROUP);
    patiently("next incarnation")
        .until(() -> robot.phoenix().group(GROUP).pid() > 0 && drive.readiness().serves());
    Timing timing = killed.stop();
    assertThat(robot.phoenix().group(GROUP).pid()).isNotEqualTo(pid);
    figures.back(timing);
    System.out.printf("after kill %d: %s%n", figures.kills(), timing);
  }

  private void print() {
    figures.figures().all().forEach(each -> System.out.println(each.line()));
  }
}
