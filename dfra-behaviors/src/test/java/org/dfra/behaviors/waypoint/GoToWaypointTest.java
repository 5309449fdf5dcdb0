package org.dfra.behaviors.waypoint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.behaviors.ScriptedRobot.at;

import java.time.Duration;
import java.util.Map;
import java.util.UUID;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.behavior.LegGoal;
import org.dfra.behaviors.ScriptedRobot;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.SourceLocation;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.geometry.GeoPosition;
import org.dfra.module.NotReadyException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class GoToWaypointTest {

  private static final LegGoal TEN_METRES = new LegGoal(null, at(10, 0), 0.4);

  private final ScriptedRobot robot = new ScriptedRobot();

  @AfterEach
  void end() {
    robot.close();
  }

  @Test
  void drivesToTheEndOfItsLineAndLetsGoOfTheWheels() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    UUID goal = goTo.pursue(TEN_METRES);
    robot.time.step(3);
    assertThat(robot.drive.driveState().commander()).isNotNull();
    assertThat(robot.reaches(goTo, Phase.SUCCEEDED, 60)).as("%s", goTo.status()).isTrue();
    assertThat(goTo.status().goal()).isEqualTo(goal);
    assertThat(robot.distanceTo(10, 0)).isLessThanOrEqualTo(0.4);
    assertThat(robot.drive.driveState().commander()).isNull();
    assertThat(robot.drive.turning).isEqualTo(Velocity.ZERO);
  }

  @Test
  void stopsWhenItsTimeLimitHasPassedThoughNobodyEndsIt() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    UUID unused = goTo.pursue(TEN_METRES.withTimeLimit(Duration.ofSeconds(4)));
    robot.time.step(3);
    assertThat(goTo.status().phase()).isEqualTo(Phase.RUNNING);
    assertThat(robot.east).isGreaterThan(0.2);
    assertThat(robot.reaches(goTo, Phase.FAILED, 1.5)).as("%s", goTo.status()).isTrue();
    assertThat(goTo.status().activity()).isEqualTo("its time limit of 4.0 s has passed");
    assertThat(robot.drive.driveState().commander()).as("the wheels are let go").isNull();
    double stopped = robot.east;
    robot.time.step(5);
    assertThat(robot.east).isEqualTo(stopped);
  }

  @Test
  void drivesOnWithoutAStopWhereItIsGivenALongerTimeLimit() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    UUID goal = goTo.pursue(TEN_METRES.withTimeLimit(Duration.ofSeconds(4)));
    robot.time.step(3);
    goTo.setTimeLimit(UUID.randomUUID(), Duration.ofSeconds(100)); // another's
    goTo.setTimeLimit(goal, Duration.ofSeconds(4));
    double before = robot.east;
    for (int i = 0; i < 30; i++) {
      robot.time.step(0.1);
      assertThat(robot.drive.turning.speed()).as("metres per second").isGreaterThan(0.1);
    }
    assertThat(robot.east).isGreaterThan(before + 0.3);
    assertThat(robot.reaches(goTo, Phase.FAILED, 1.5)).as("%s", goTo.status()).isTrue();
    assertThat(goTo.status().activity()).isEqualTo("its time limit of 7.0 s has passed");
    goTo.setTimeLimit(goal, Duration.ofSeconds(4));
    robot.time.step(1);
    assertThat(goTo.status().phase()).as("what has ended stays so").isEqualTo(Phase.FAILED);
  }

  @Test
  void joinsTheLineThatItIsGiven() throws Exception {
    robot.north = -3;
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    UUID unused = goTo.pursue(new LegGoal(at(0, 0), at(20, 0), 0.4));
    assertThat(robot.time.until(() -> robot.east > 12, 60)).isTrue();
    assertThat(Math.abs(robot.north)).as("metres off the line").isLessThan(0.3);
  }

  @Test
  void standsWhileThereIsNoRoomToBeSeenAndGoesOn() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    UUID unused = goTo.pursue(TEN_METRES);
    assertThat(robot.time.until(() -> robot.east > 2, 30)).isTrue();
    robot.seesRoom = false;
    assertThat(robot.reachesActivity(goTo, "it waits: atrv1/range_filter", 1)).isTrue();
    double stood = robot.east;
    robot.time.step(20);
    assertThat(robot.east).isEqualTo(stood);
    assertThat(robot.drive.driveState().commander()).as("the wheels are let go").isNull();
    assertThat(goTo.status().activity())
        .isEqualTo("it waits: atrv1/range_filter is INITIALIZING: no Clearance has come for 0.5 s");
    robot.seesRoom = true;
    assertThat(robot.reaches(goTo, Phase.SUCCEEDED, 60)).as("%s", goTo.status()).isTrue();
  }

  @Test
  void isNotMovedByPerceptsThatWereHeldUpOnTheirWay() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    UUID unused = goTo.pursue(TEN_METRES);
    assertThat(robot.time.until(() -> robot.east > 2, 30)).isTrue();
    robot.roomDelay = Duration.ofMillis(300);
    robot.time.step(2);
    assertThat(robot.east).as("0.3 s old counts").isGreaterThan(2.5);
    robot.roomDelay = Duration.ofSeconds(2); // they come as often as ever
    assertThat(robot.reachesActivity(goTo, "it waits: atrv1/range_filter", 1)).isTrue();
    double stood = robot.east;
    robot.time.step(5);
    assertThat(robot.east).isEqualTo(stood);
    robot.roomDelay = Duration.ZERO;
    assertThat(robot.reaches(goTo, Phase.SUCCEEDED, 60)).as("%s", goTo.status()).isTrue();
  }

  @Test
  void standsWhileItDoesNotKnowWhereItIs() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    UUID unused = goTo.pursue(TEN_METRES);
    assertThat(robot.time.until(() -> robot.east > 2, 30)).isTrue();
    robot.seesPlace = false;
    assertThat(robot.reachesActivity(goTo, "it waits: atrv1/heading_error", 1)).isTrue();
    double stood = robot.east;
    robot.time.step(5);
    assertThat(robot.east).isEqualTo(stood);
    robot.seesPlace = true;
    assertThat(robot.reaches(goTo, Phase.SUCCEEDED, 60)).isTrue();
  }

  @Test
  void acquiresTheWheelsAgainWhenItsLeaseIsRevoked() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    UUID unused = goTo.pursue(TEN_METRES);
    assertThat(robot.time.until(() -> robot.east > 2, 30)).isTrue();
    robot.drive.leases().leases().forEach(lease -> robot.drive.leases().revoke(lease.handle()));
    assertThat(robot.drive.turning).isEqualTo(Velocity.ZERO);
    assertThat(robot.reaches(goTo, Phase.SUCCEEDED, 60)).as("%s", goTo.status()).isTrue();
  }

  @Test
  void waitsWhileAnotherCommandsTheWheels() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    try (CommandLease other = robot.drive.acquireCommandLease(Duration.ofSeconds(10))) {
      UUID unused = goTo.pursue(TEN_METRES);
      robot.time.step(3);
      assertThat(goTo.status().activity()).startsWith("it waits: atrv1/drive is commanded by");
      assertThat(other.isLive()).isTrue();
      assertThat(robot.east).isZero();
    }
    assertThat(robot.reaches(goTo, Phase.SUCCEEDED, 60)).isTrue();
  }

  @Test
  void givesUpAtAnEmergencyStopAndStandsAfterItsRelease() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    UUID unused = goTo.pursue(TEN_METRES);
    assertThat(robot.time.until(() -> robot.east > 2, 30)).isTrue();
    Object stopped = robot.drive.emergencyStop("a test");
    assertThat(robot.drive.turning).as("%s", stopped).isEqualTo(Velocity.ZERO);
    assertThat(robot.reaches(goTo, Phase.CANCELLED, 1)).isTrue();
    assertThat(goTo.status().activity()).contains("atrv1/drive", "emergency");
    double stood = robot.east;
    Object released = robot.drive.releaseEmergencyStop("a test");
    robot.time.step(10);
    assertThat(robot.east).as("%s", released).isEqualTo(stood);
    UUID again = goTo.pursue(TEN_METRES);
    assertThat(again).isNotNull();
    assertThat(robot.reaches(goTo, Phase.SUCCEEDED, 60)).isTrue();
  }

  @Test
  void givesUpAlsoWhereItWasReleasedBeforeItsNextTurn() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    UUID unused = goTo.pursue(TEN_METRES);
    assertThat(robot.time.until(() -> robot.east > 2, 30)).isTrue();
    Object stopped = robot.drive.emergencyStop("a test");
    Object released = robot.drive.releaseEmergencyStop("a test");
    double stood = robot.east;
    assertThat(robot.reaches(goTo, Phase.CANCELLED, 1)).as("%s, %s", stopped, released).isTrue();
    robot.time.step(10);
    assertThat(robot.east).isEqualTo(stood);
  }

  @Test
  void getsItselfOutAndGivesUpAfterSoManyAttempts() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of("max_recoveries", "2"));
    robot.isHeld = true;
    UUID unused = goTo.pursue(TEN_METRES);
    assertThat(robot.reachesActivity(goTo, "it was stuck and recovers", 8)).isTrue();
    robot.time.step(0.5);
    assertThat(robot.drive.turning).as("back first").isEqualTo(new Velocity(-0.25, 0));
    robot.time.step(1.5);
    assertThat(robot.drive.turning.speed()).as("then a turn").isZero();
    double firstTurn = robot.drive.turning.yawRate();
    assertThat(robot.reaches(goTo, Phase.FAILED, 60)).as("%s", goTo.status()).isTrue();
    assertThat(goTo.status().activity())
        .isEqualTo("it cannot get nearer than 10.0 m; an obstacle blocks the path");
    assertThat(robot.drive.velocities)
        .as("the second time it turns to the other side")
        .contains(new Velocity(0, -firstTurn));
    assertThat(robot.drive.turning).isEqualTo(Velocity.ZERO);
  }

  @Test
  void drivesStraightOnWhileItDoesNotKnowWhichWayItFaces() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    robot.yawSigma = 1.8;
    robot.time.step(0.3);
    UUID unused = goTo.pursue(new LegGoal(null, at(0, 10), 0.4)); // to its left
    assertThat(robot.time.until(() -> robot.east > 1.5, 10)).isTrue();
    assertThat(goTo.status().activity()).startsWith("it drives straight on to determine its yaw");
    assertThat(Math.abs(robot.north)).isLessThan(0.05);
    robot.yawSigma = 0.05;
    assertThat(robot.reaches(goTo, Phase.SUCCEEDED, 60)).as("%s", goTo.status()).isTrue();
  }

  @Test
  void refusesAWaypointAThousandKilometresAwayBeforeAnythingMoves() {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    assertThatThrownBy(() -> goTo.pursue(new LegGoal(null, new GeoPosition(57, 11, 0), 0.4)))
        .isInstanceOf(GoalRefusedException.class)
        .hasMessageContaining("km from the robot at 48.0000000°,11.0000000°");
    GeoPosition beginning = new GeoPosition(39, 11, 0);
    assertThatThrownBy(() -> goTo.pursue(new LegGoal(beginning, at(1, 0), 0.4)))
        .isInstanceOf(GoalRefusedException.class);
    robot.time.step(2);
    assertThat(goTo.status().phase()).isEqualTo(Phase.IDLE);
    assertThat(robot.drive.velocities).isEmpty();
  }

  @Test
  void countsALegWhoseEndItHasPassedNearby() throws Exception {
    robot.east = 10.5;
    robot.north = 0.5;
    robot.time.step(0.2);
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    UUID unused = goTo.pursue(new LegGoal(at(0, 0), at(10, 0), 0.1));
    assertThat(robot.reaches(goTo, Phase.SUCCEEDED, 0.5)).as("%s", goTo.status()).isTrue();
    assertThat(goTo.status().activity()).isEqualTo("it has reached the waypoint, 0.71 m from it");
  }

  @Test
  void drivesToAPlaceThatIsALineOfNoLengthWithoutThinkingItIsStuck() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of("max_recoveries", "0"));
    UUID unused = goTo.pursue(new LegGoal(at(10, 0), at(10, 0), 0.4));
    assertThat(robot.reaches(goTo, Phase.SUCCEEDED, 60)).as("%s", goTo.status()).isTrue();
  }

  @Test
  void namesThePlaceWhereASchemaIsNamedThatIsNotThere() {
    Parameters parameters =
        new Parameters(
            "atrv1/go_to_waypoint",
            Map.of(
                "range_filter",
                new Parameters.Value("sonar_filter", new SourceLocation("atrv1.xml", 71))));
    GoToWaypointImpl goTo =
        robot.add(new GoToWaypointImpl(robot.context("go_to_waypoint", parameters)));
    assertThatThrownBy(() -> goTo.pursue(TEN_METRES))
        .isInstanceOf(NotReadyException.class)
        .hasMessage(
            "atrv1/go_to_waypoint is INITIALIZING: it needs a RangeFilter named sonar_filter on"
                + " atrv1, and there is none; atrv1.xml:71 names it");
    assertThat(robot.drive.velocities).isEmpty();
  }

  @Test
  void usesAnotherModuleWhereTheOneItUsedIsGone() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    UUID unused = goTo.pursue(TEN_METRES);
    assertThat(robot.time.until(() -> robot.east > 2, 30)).isTrue();
    robot.seesRoom = false;
    robot.end(robot.clearance);
    assertThat(robot.reachesActivity(goTo, "it waits: ", 1)).isTrue();
    ScriptedRobot.Room other = robot.add(robot.new Room("other_filter"));
    robot.seesRoom = true;
    robot.seer = other;
    assertThat(robot.reaches(goTo, Phase.SUCCEEDED, 60)).as("%s", goTo.status()).isTrue();
  }
}
