package org.dfra.drive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * {@code ./dfra stop}, typed in a checkout whose sources do not compile while another builds there,
 * halts a robot that drives within a second.
 */
@Timeout(240)
class FirstOrderIT {

  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final Duration LEASE = Duration.ofSeconds(10);
  private static final Velocity AHEAD = new Velocity(1, 0);

  /** From the start of the script to the first order that the controller of the wheels gets. */
  private static final Duration FIRST_ORDER = Duration.ofSeconds(1);

  /** Of which the median counts. */
  private static final int ROUNDS = 3;

  @TempDir Path folder;

  @Test
  void theScriptHaltsTheWheelsInTimeWhereNothingCanBeBuilt() throws Exception {
    try (StallProbe probe = StallProbe.start();
        ScriptCopy checkout = new ScriptCopy(folder.resolve("checkout"));
        WheeledRobot robot = WheeledRobot.start(folder, "drive")) {
      checkout.lock();
      Process build = checkout.start("build");
      assertThat(build.inputReader().readLine())
          .isEqualTo("dfra: waiting for another ./dfra that builds or tests here");
      List<Timing> orders = new ArrayList<>();
      for (int round = 1; round <= ROUNDS; round++) {
        robot.reset();
        orders.add(firstOrder(robot, checkout, probe));
      }
      assertThat(build.isAlive()).as("the build still waits").isTrue();
      orders.sort(Comparator.comparing(Timing::took));
      orders
          .get(ROUNDS / 2)
          .requireWithin("./dfra stop --all, the script, to its first order", FIRST_ORDER);
    }
  }

  private static Timing firstOrder(WheeledRobot robot, ScriptCopy checkout, StallProbe probe)
      throws Exception {
    try (Commander unused = robot.driven(LEASE, AHEAD)) {
      robot.awaitFullSpeed();
      StallProbe.Stopwatch running = probe.stopwatch();
      Instant typed = Instant.now();
      Process stop =
          checkout.start(
              "stop",
              "--all",
              "--team=",
              "--host=" + WheeledRobot.HOST,
              "--wait=20",
              "--state=" + robot.phoenix().process().state());
      String output = new String(stop.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      Timing whole = running.stop();
      assertThat(stop.waitFor()).as(output).isZero();
      assertThat(output)
          .isEqualTo(
              "eta/drive: stopped.\n1 effector: 1 stopped.\n"
                  + "dfra: these jars are older than the sources; type ./dfra build to create new ones\n");
      await().atMost(PATIENCE).until(() -> robot.wheels().firstHalt() != null);
      Instant ordered = Objects.requireNonNull(robot.wheels().firstHalt(), "no order came");
      assertThat(robot.drive().emergencyStopState().latched()).isTrue();
      Duration took = Duration.between(typed, ordered);
      System.out.printf(
          "the first order came %.3f s after the script began%n", took.toNanos() / 1e9);
      return whole.ofPart(took);
    }
  }
}
