package org.dfra.drive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.Objects;
import java.util.stream.Stream;
import org.dfra.core.config.RobotXml;
import org.dfra.core.query.QueryParser;
import org.dfra.core.query.QueryTypeNames;
import org.dfra.directory.ModuleQuery;
import org.dfra.drive.WheeledRobot.CommandResult;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.river.bootstrap.RobotDescriptionStore;
import org.dfra.robot.RunningPhoenix;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * {@code ./dfra stop} halts a robot that drives, whatever else has died, and it stays so. {@link
 * FirstOrderIT} judges how soon, since it types the command as a user does. All tests share the
 * robot, which each finds as it was at first.
 */
@Timeout(240)
class StopIT {

  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final Duration LEASE = Duration.ofSeconds(10);
  private static final Velocity AHEAD = new Velocity(1, 0);

  @TempDir static Path folder;

  private static WheeledRobot robot;
  private static Wheels wheels;
  private static RunningPhoenix phoenix;
  private static DriveEffector drive;

  @BeforeAll
  static void bringUp() throws Exception {
    robot = WheeledRobot.start(folder, "drive");
    wheels = robot.wheels();
    phoenix = robot.phoenix();
    drive = robot.drive();
  }

  @BeforeEach
  void reset() throws Exception {
    remember(robot.xml());
    robot.reset();
  }

  @AfterAll
  static void takeDown() throws Exception {
    if (robot != null) { // else it has said why, and nothing is left of it
      robot.close();
    }
  }

  private static void remember(Path xml) throws Exception {
    new RobotDescriptionStore(phoenix.process().state()).save(RobotXml.read(xml));
  }

  /** {@code ./dfra stop}, as a process. */
  private static CommandResult stop(String... words) throws Exception {
    return robot.ask(verb(words));
  }

  /** The same in this process. */
  private static CommandResult stopHere(String... words) throws Exception {
    return robot.askHere(verb(words));
  }

  private static String[] verb(String... words) {
    return Stream.concat(Stream.of("stop"), Arrays.stream(words)).toArray(String[]::new);
  }

  /** Waits until the wheels stand, and prints how long they needed. */
  private void assertTheyStand(Instant since, String what) {
    wheels.assertTheyStoodWithinHalfASecondOfTheLastCommand();
    Instant stood = Objects.requireNonNull(wheels.standingSince(), "they move");
    System.out.printf(
        "the wheels stood %.3f s after %s%n", Duration.between(since, stood).toNanos() / 1e9, what);
  }

  private void assertNobodyCommands() {
    assertThatThrownBy(() -> drive.acquireCommandLease(LEASE))
        .isInstanceOf(LeaseRefusedException.class)
        .hasMessageStartingWith("eta/drive is stopped for an emergency since 2")
        .hasMessageEndingWith("when it is safe, release it: ./dfra stop --release eta");
  }

  @Test
  void stopsARobotThatDrivesUntilItIsReleasedAlsoWhereItsProcessIsKilled() throws Exception {
    try (Commander commander = robot.driven(LEASE, AHEAD)) {
      robot.awaitFullSpeed();
      Instant typed = Instant.now();
      CommandResult result = stop("--all");
      assertThat(result)
          .isEqualTo(new CommandResult(0, "eta/drive: stopped.\n1 effector: 1 stopped.\n"));
      assertTheyStand(typed, "./dfra stop --all was typed");
      await().atMost(PATIENCE).until(commander::hasGivenUp);
      await().atMost(PATIENCE).until(() -> !commander.lease().isLive());
    }
    assertNobodyCommands();
    assertThat(stopHere("eta").text()).startsWith("eta/drive: was stopped already, since 2");
    assertThat(robot.dfraHere("status").text())
        .contains("eta/drive is stopped for an emergency since 2");

    phoenix.kill("eta.wheels");
    phoenix.note();
    WheeledRobot.patiently().until(() -> drive.awaitReadiness(PATIENCE).serves());
    phoenix.note();
    EmergencyStopState kept = drive.emergencyStopState();
    assertThat(kept.latched()).as("in the next incarnation").isTrue();
    assertNobodyCommands();
    assertThat(robot.dfraHere("up", robot.xml().toString()).text())
        .contains("But eta/drive is stopped for an emergency since " + kept.since());
    ModuleQuery<?> query =
        new QueryParser(QueryTypeNames.standard())
            .parse("DriveEffector with emergency_stop.latched = true");
    assertThat(robot.directory().findFirst(query, PATIENCE)).isPresent();

    assertThat(stop("--release", "eta"))
        .isEqualTo(new CommandResult(0, "eta/drive: released.\n1 effector: 1 released.\n"));
    assertThat(wheels.speed()).as("releasing moves nothing").isZero();
    try (Commander unused = robot.driven(LEASE, AHEAD)) {
      robot.awaitFullSpeed();
    }
    wheels.assertTheyStoodWithinHalfASecondOfTheLastCommand();
  }

  @Test
  void stopsTheRobotsOfItsHostAlsoWhereNoLookupServiceAnswers() throws Exception {
    try (Commander unused = robot.driven(LEASE, AHEAD)) {
      robot.awaitFullSpeed();
      long pid = phoenix.group("eta.lookup").pid();
      WheeledRobot.signal("STOP", pid);
      try {
        Instant typed = Instant.now();
        CommandResult result =
            robot.dfra("stop", "--all", "--team=", "--host=" + WheeledRobot.HOST, "--wait=1");
        assertThat(result)
            .isEqualTo(new CommandResult(0, "eta/drive: stopped.\n1 effector: 1 stopped.\n"));
        assertTheyStand(typed, "./dfra stop --all was typed, without a lookup service");
      } finally {
        WheeledRobot.signal("CONT", pid);
      }
    }
    assertNobodyCommands();
  }

  @Test
  void stopsAlsoWhereWhatIsSetForItIsWrong() throws Exception {
    try (Commander unused = robot.driven(LEASE, AHEAD)) {
      robot.awaitFullSpeed();
      Instant typed = Instant.now();
      CommandResult result =
          robot.dfraHere(
              "stop",
              "--all",
              "--team=",
              "--host=203.0.113.9",
              "--locator=nowhere:99999",
              "--wait=-1");
      assertThat(result.text())
          .contains(
              "eta/drive: stopped.",
              "host 203.0.113.9 is not an address of this machine",
              "the lookup service jini://nowhere:99999 cannot be asked: ",
              "--wait=-1.0 is not a number of seconds from 0 to 3600; it waits 2 s");
      assertThat(result.status()).as("a lookup service was not asked").isEqualTo(4);
      assertTheyStand(typed, "./dfra stop --all was typed, with wrong options");
    }
    assertNobodyCommands();
  }

  /** Its XML was edited and remembered, but up did not get to end what ran before. */
  @Test
  void stopsAnEffectorThatTheXmlHasUnderAnotherNameNow() throws Exception {
    Path edited = folder.resolve("edited.xml");
    Files.writeString(
        edited, Files.readString(robot.xml()).replace("name=\"drive\"", "name=\"motor\""));
    remember(edited);
    try (Commander unused = robot.driven(LEASE, AHEAD)) {
      robot.awaitFullSpeed();
      long pid = phoenix.group("eta.lookup").pid();
      WheeledRobot.signal("STOP", pid);
      try {
        Instant typed = Instant.now();
        CommandResult result =
            robot.dfraHere("stop", "--all", "--team=", "--host=" + WheeledRobot.HOST, "--wait=1");
        assertThat(result.text())
            .contains("eta/drive: stopped.\n", "eta/motor: NOT STOPPED: phoenix of this host");
        assertThat(result.status()).isEqualTo(4);
        assertTheyStand(typed, "./dfra stop --all was typed, under a name that no XML has");
      } finally {
        WheeledRobot.signal("CONT", pid);
      }
    }
    assertNobodyCommands();
  }

  @Test
  void saysWhomItCouldNotReach() throws Exception {
    long pid = phoenix.group("eta.wheels").pid();
    WheeledRobot.signal("STOP", pid);
    try {
      CommandResult result = stop("--all");
      assertThat(result.status()).as(result.text()).isEqualTo(4);
      assertThat(result.text())
          .startsWith("eta/drive: NOT STOPPED: ")
          .endsWith("1 effector: 1 NOT STOPPED. Use the robot's own emergency stop.\n");
    } finally {
      // Not let go on: it might still stop then, of the orders in its sockets, in the next test.
      phoenix.kill("eta.wheels");
    }
    assertThat(stopHere("theta", "--json").status()).as("there is no such robot").isEqualTo(3);
    assertThat(stopHere().status()).as("neither a robot nor --all").isEqualTo(2);
    assertThat(stopHere("eta", "--all").status()).as("both").isEqualTo(2);
  }

  @Test
  void aProxyStopsTheWheelsAsQuickly() throws Exception {
    try (Commander unused = robot.driven(LEASE, AHEAD)) {
      robot.awaitFullSpeed();
      Instant called = Instant.now();
      assertThat(drive.emergencyStop("a test").latched()).isTrue();
      System.out.printf(
          "the call of emergencyStop took %.3f s%n",
          Duration.between(called, Instant.now()).toNanos() / 1e9);
      assertTheyStand(called, "emergencyStop was called");
    }
  }
}
