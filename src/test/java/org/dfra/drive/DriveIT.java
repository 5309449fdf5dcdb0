package org.dfra.drive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import org.dfra.core.query.QueryParser;
import org.dfra.core.query.QueryTypeNames;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.directory.ModuleListing;
import org.dfra.example.thermometer.SteadyThermometerImpl;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.sensor.BatterySensor;
import org.dfra.flow.sensor.OdometrySensor;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lifecycle.Incident;
import org.dfra.module.Module;
import org.dfra.robot.RunningPhoenix;
import org.dfra.testing.InteractiveProcess;
import org.dfra.testing.ServedModule;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * A robot's wheels, odometry and battery in one group, a process of its own; whichever of them
 * dies, the wheels stop in time. All tests share the robot, which each finds as it was at first.
 */
@Timeout(180)
class DriveIT {

  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final Velocity AHEAD = new Velocity(1, 0);

  /** As short as a busy machine allows, for those tests that wait for its end. */
  private static final Duration SHORT_LEASE = Duration.ofSeconds(5);

  /** It is renewed before; 0.5 s are for a look every 0.1 s, and for the answer. */
  private static final Duration LEASE_OVER = SHORT_LEASE.plusMillis(500);

  /** After 1 s without a report a link counts as lost; a report is due every 0.1 s. */
  private static final Duration SILENCE = Duration.ofMillis(900);

  @TempDir static Path folder;

  private static final StallProbe probe = StallProbe.start();
  private static WheeledRobot robot;
  private static Wheels wheels;
  private static RunningPhoenix phoenix;
  private static DriveEffector drive;
  private static OdometrySensor odometry;
  private static BatterySensor battery;

  @BeforeAll
  static void bringUp() throws Exception {
    StallProbe.Stopwatch running = probe.stopwatch();
    robot = WheeledRobot.start(folder, "drive", "odometry", "battery");
    wheels = robot.wheels();
    phoenix = robot.phoenix();
    drive = robot.drive();
    odometry = (OdometrySensor) find("OdometrySensor with sensor.reading = Odometry").module();
    battery = (BatterySensor) find("BatterySensor").module();
    awaitAll();
    for (Module each : List.of(drive, odometry, battery)) {
      assertNoFailures(each, Instant.MIN, running.stop());
    }
  }

  @BeforeEach
  void reset() throws Exception {
    robot.reset();
    awaitAll();
  }

  private static void awaitAll() throws Exception {
    assertThat(odometry.awaitReadiness(PATIENCE).serves()).isTrue();
    assertThat(battery.awaitReadiness(PATIENCE).serves()).isTrue();
  }

  @AfterAll
  static void takeDown() throws Exception {
    probe.close();
    if (robot != null) { // else it has said why, and nothing is left of it
      robot.close();
    }
  }

  private static ModuleListing<?> find(String query) throws Exception {
    return robot
        .directory()
        .findFirst(new QueryParser(QueryTypeNames.standard()).parse(query), PATIENCE)
        .orElseThrow();
  }

  @Test
  void threeModulesShareOneControllerAndAreFoundByWhatTheyCanDo() throws Exception {
    StallProbe.Stopwatch running = probe.stopwatch();
    Instant began = Instant.now().truncatedTo(ChronoUnit.MILLIS);
    ModuleListing<?> counted = find("OdometrySensor with sensor.reading = Odometry");
    ModuleListing<?> fed = find("BatterySensor");
    assertThat(counted.module()).isEqualTo(odometry);
    assertThat(fed.module()).isEqualTo(battery);
    assertThat(find("DriveEffector with drive.length <= 0.8").attributes())
        .asString()
        .contains("maxSpeed=1.0", "length=0.78", "width=0.64", "Brake", "Velocity");
    double driven = wheels.distance();
    AtomicReference<Double> counts = new AtomicReference<>();
    WheeledRobot.patiently().untilAsserted(() -> counts.set(odometry.odometry().x()));
    try (Commander unused = new Commander(drive, Duration.ofSeconds(10), new Velocity(0.5, 0))) {
      await().atMost(PATIENCE).until(() -> wheels.distance() > driven + 0.5);
      WheeledRobot.patiently().until(() -> odometry.odometry().x() > counts.get() + 0.5);
      assertThat(odometry.odometry().childFrame()).isEqualTo("eta/base_link");
      assertThat(battery.battery().voltage()).isBetween(25.19, 25.21);
    }
    wheels.assertTheyStoodWithinHalfASecondOfTheLastCommand();
    for (Module each : List.of(drive, odometry, battery)) {
      assertNoFailures(each, began, running.stop());
    }
  }

  /** A lost link is excused only by a stall of the computer that is long enough to lose it. */
  private static void assertNoFailures(Module module, Instant since, Timing timing)
      throws RemoteException {
    List<String> failures =
        module.history().recent().stream()
            .filter(incident -> incident.kind() == Incident.Kind.FAILURE)
            .filter(incident -> !incident.time().isBefore(since))
            .map(Incident::description)
            .toList();
    assertThat(failures)
        .as("failures of %s; %s", module, timing)
        .allMatch(what -> what.matches(".*\\bno report .* (for|has come within) .*"));
    timing.requireNone("lost links of " + module + " " + failures, failures.size(), SILENCE);
  }

  @Test
  void theWheelsStandInTimeWhenTheGroupThatDrivesThemIsKilled() throws Exception {
    try (Commander commander = new Commander(drive, SHORT_LEASE, AHEAD)) {
      robot.awaitFullSpeed();
      phoenix.kill("eta.wheels");
      await().atMost(PATIENCE).until(commander::hasGivenUp);
      wheels.assertTheyStoodWithinHalfASecondOfTheLastCommand();

      assertThatThrownBy(() -> drive.execute(commander.lease().key(), AHEAD))
          .as("in the next incarnation, which the call brings back")
          .isInstanceOf(CommandRefusedException.class);
      phoenix.note();
      await().atMost(PATIENCE).until(() -> !commander.lease().isLive());
    }
    WheeledRobot.patiently().until(() -> drive.awaitReadiness(PATIENCE).serves());
    try (Commander unused = new Commander(drive, Duration.ofSeconds(10), AHEAD)) {
      robot.awaitFullSpeed();
    }
    wheels.assertTheyStoodWithinHalfASecondOfTheLastCommand();
  }

  @Test
  void theWheelsStandInTimeWhenTheirCommanderIsKilledAndAnotherMayCommand() throws Exception {
    try (InteractiveProcess commander = commander(Long.toString(SHORT_LEASE.toMillis()))) {
      assertThat(commander.awaitLine()).isEqualTo("commanding");
      robot.awaitFullSpeed();
      assertThatThrownBy(() -> drive.acquireCommandLease(Duration.ofSeconds(1)))
          .isInstanceOf(LeaseRefusedException.class)
          .hasMessageContaining("eta/drive is commanded by a client at 127.0.0.1 since");
      ProcessHandle victim = ProcessHandle.of(commander.pid()).orElseThrow();
      StallProbe.Stopwatch killed = probe.stopwatch();
      victim.destroyForcibly();
      await().atMost(PATIENCE).until(() -> !victim.isAlive());
      wheels.assertTheyStoodWithinHalfASecondOfTheLastCommand();
      WheeledRobot.patiently().until(() -> drive.driveState().commander() == null);
      killed.stop().requireWithin("the end of a dead commander's lease", LEASE_OVER);
    }
    try (Commander unused = new Commander(drive, Duration.ofSeconds(10), AHEAD)) {
      robot.awaitFullSpeed();
    }
  }

  @Test
  void theWheelsStopInTimeWhenTheirCommanderIsSuspendedAndStayStoppedWhenItIsResumed()
      throws Exception {
    long timeouts = drive.driveState().commandTimeouts();
    try (InteractiveProcess commander = commander(Long.toString(SHORT_LEASE.toMillis()))) {
      assertThat(commander.awaitLine()).isEqualTo("commanding");
      robot.awaitFullSpeed();
      Instant last;
      StallProbe.Stopwatch suspended = probe.stopwatch();
      WheeledRobot.signal("STOP", commander.pid());
      try {
        wheels.assertTheyStoodWithinHalfASecondOfTheLastCommand();
        WheeledRobot.patiently()
            .untilAsserted(
                () ->
                    assertThat(drive.driveState().commandTimeouts())
                        .as("command time-outs of the driver")
                        .isGreaterThan(timeouts));
        WheeledRobot.patiently().until(() -> drive.driveState().commander() == null);
        suspended.stop().requireWithin("the end of a suspended commander's lease", LEASE_OVER);
        last = wheels.lastMotion();
      } finally {
        WheeledRobot.signal("CONT", commander.pid());
      }
      assertThat(commander.awaitLine()) // its next command, or the one that it had sent
          .startsWith("ended: ")
          .containsAnyOf("CommandRefusedException", "DeadlineExceededException", "does not answer");
      assertThat(wheels.lastMotion()).as("the last motion, once it is resumed").isEqualTo(last);
      assertThat(wheels.standingSince()).as("they stand").isNotNull();
    }
  }

  @Test
  void theWheelsStandInTimeWhenAnAdministratorRevokesTheirCommander() throws Exception {
    try (Commander commander = new Commander(drive, Duration.ofSeconds(10), AHEAD)) {
      robot.awaitFullSpeed();
      String listed = answered(robot.askHere("lease", "list", "eta/drive"));
      assertThat(listed.replaceAll(" +", " "))
          .contains("eta/drive commander a program at 127.0.0.1 ");
      String row = listed.lines().filter(each -> each.contains("commander")).findFirst().get();
      String lease = row.substring(row.lastIndexOf(' ') + 1);
      assertThat(answered(robot.ask("lease", "revoke", "eta/drive", lease)))
          .startsWith("Revoked lease " + lease);
      await().atMost(PATIENCE).until(commander::hasGivenUp);
      wheels.assertTheyStoodWithinHalfASecondOfTheLastCommand();
      await().atMost(PATIENCE).until(() -> !commander.lease().isLive());
      assertThat(drive.driveState().commander()).isNull();
    }
  }

  /** A module of this process is known to hold what this process holds. */
  @Test
  void aLeaseIsListedWithTheModuleThatHoldsItInsteadOfAnAddress() throws Exception {
    ServedModule<ThermometerServer> explorer =
        ServedModule.of(
                ThermometerServer.class, ThermometerProxy.class, SteadyThermometerImpl.class)
            .on("eta")
            .named("explorer")
            .joining(robot.locator());
    try (ThermometerServer serving = explorer.serve();
        Commander commander = new Commander(drive, Duration.ofSeconds(10), AHEAD)) {
      await()
          .atMost(PATIENCE)
          .untilAsserted(
              () ->
                  assertThat(answered(robot.askHere("lease", "list", "eta/drive")))
                      .as("%s and %s", serving, commander)
                      .containsPattern("eta/drive +commander +eta/explorer ")
                      .doesNotContain("127.0.0.1"));
    }
  }

  /** What {@code ./dfra} has answered to a question that it can answer. */
  private static String answered(WheeledRobot.CommandResult result) {
    assertThat(result.status()).as(result.text()).isZero();
    return result.text();
  }

  @Test
  void theWheelsStandInTimeWhenTheGroupThatDrivesThemHangs() throws Exception {
    try (Commander commander = new Commander(drive, Duration.ofSeconds(10), AHEAD)) {
      robot.awaitFullSpeed();
      long pid = phoenix.group("eta.wheels").pid();
      WheeledRobot.signal("STOP", pid);
      try {
        wheels.assertTheyStoodWithinHalfASecondOfTheLastCommand();
        await().atMost(PATIENCE).until(commander::hasGivenUp);
      } finally {
        WheeledRobot.signal("CONT", pid);
      }
    }
    WheeledRobot.patiently().until(() -> drive.driveState().commander() == null);
    wheels.assertTheyStoodWithinHalfASecondOfTheLastCommand();
  }

  private InteractiveProcess commander(String leaseMillis) throws Exception {
    List<String> command =
        new ArrayList<>(InteractiveProcess.java(System.getProperty("java.class.path"), List.of()));
    command.addAll(List.of(Commander.class.getName(), robot.locator(), leaseMillis));
    return new InteractiveProcess(command);
  }
}
