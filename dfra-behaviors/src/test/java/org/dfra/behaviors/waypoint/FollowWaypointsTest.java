package org.dfra.behaviors.waypoint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.behaviors.ScriptedRobot.at;

import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.behavior.LegGoal;
import org.dfra.behavior.PathGoal;
import org.dfra.behaviors.ScriptedRobot;
import org.dfra.geometry.GeoPosition;
import org.dfra.module.NotReadyException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class FollowWaypointsTest {

  private static final PathGoal THREE =
      new PathGoal(null, List.of(at(6, 0), at(6, 6), at(0, 6)), 0.4);

  private final ScriptedRobot robot = new ScriptedRobot();

  @AfterEach
  void end() {
    robot.close();
  }

  private FollowWaypointsImpl addFollow() {
    return robot.add(new FollowWaypointsImpl(robot.context("follow_waypoints", Map.of())));
  }

  @Test
  void goesToAllInOrderAndReportsHowManyAreDone() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    FollowWaypointsImpl follow = addFollow();
    UUID goal = follow.pursue(THREE);
    assertThat(robot.reachesActivity(follow, "waypoint 2 of 3", 60)).isTrue();
    assertThat(robot.distanceTo(6, 0)).isLessThan(0.5);
    assertThat(follow.status().completion()).isBetween(1 / 3.0, 0.5);
    assertThat(follow.status().completedParts()).isEqualTo(1);
    assertThat(follow.status().totalParts()).isEqualTo(3);
    assertThat(robot.reaches(follow, Phase.SUCCEEDED, 90)).as("%s", follow.status()).isTrue();
    assertThat(follow.status().goal()).isEqualTo(goal);
    assertThat(follow.status().completedParts()).isEqualTo(3);
    assertThat(follow.status().activity()).isEqualTo("it has reached all waypoints");
    assertThat(robot.distanceTo(0, 6)).isLessThanOrEqualTo(0.4);
    assertThat(goTo.status().phase()).isEqualTo(Phase.SUCCEEDED);
  }

  @Test
  void leavesOutAWaypointThatIsBarredAndCountsIt() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of("max_recoveries", "0"));
    FollowWaypointsImpl follow = addFollow();
    UUID unused = follow.pursue(THREE);
    assertThat(robot.reachesActivity(follow, "waypoint 2 of 3", 60))
        .as("%s", goTo.status())
        .isTrue();
    robot.isHeld = true;
    assertThat(robot.reachesActivity(follow, "waypoint 3 of 3", 60)).isTrue();
    robot.isHeld = false;
    assertThat(robot.reaches(follow, Phase.SUCCEEDED, 90)).as("%s", follow.status()).isTrue();
    assertThat(follow.status().activity())
        .isEqualTo("1 of 3 waypoints skipped, since they could not be reached");
    assertThat(follow.status().skippedParts()).isEqualTo(1);
    assertThat(robot.distanceTo(0, 6)).isLessThanOrEqualTo(0.4);
  }

  @Test
  void failsWhereItCanGetToNone() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of("max_recoveries", "0"));
    FollowWaypointsImpl follow = addFollow();
    robot.isHeld = true;
    UUID unused = follow.pursue(THREE);
    assertThat(robot.reaches(follow, Phase.FAILED, 90)).as("%s", goTo.status()).isTrue();
    assertThat(follow.status().activity()).isEqualTo("it could reach none of its waypoints");
    assertThat(follow.status().skippedParts()).isEqualTo(3);
  }

  @Test
  void goesOnWhenWhatDrivesItsLegsHasDiedAndIsBack() throws Exception {
    GoToWaypointImpl first = robot.addGoTo(Map.of());
    FollowWaypointsImpl follow = addFollow();
    UUID goal = follow.pursue(THREE);
    assertThat(robot.time.until(() -> robot.north > 2, 60)).isTrue();
    robot.end(first);
    assertThat(robot.reachesActivity(follow, "it waits: atrv1/go_to_waypoint", 1))
        .as("%s", follow.status())
        .isTrue();
    assertThat(robot.reachesActivity(follow, "and there is none; add one to the robot's XML", 1))
        .isTrue();
    double stood = robot.north;
    robot.time.step(5);
    assertThat(robot.north).isEqualTo(stood);
    GoToWaypointImpl second = robot.addGoTo(Map.of());
    assertThat(robot.reaches(follow, Phase.SUCCEEDED, 90)).as("%s", follow.status()).isTrue();
    assertThat(follow.status().goal()).isEqualTo(goal);
    assertThat(follow.status().activity()).isEqualTo("it has reached all waypoints");
    assertThat(second.status().phase()).isEqualTo(Phase.SUCCEEDED);
  }

  @Test
  void waitsWhileSomebodyElseUsesWhatDrivesItsLegs() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    FollowWaypointsImpl follow = addFollow();
    UUID mine = goTo.pursue(new LegGoal(null, at(0, -8), 0.4));
    UUID unused = follow.pursue(THREE);
    assertThat(
            robot.reachesActivity(follow, "it waits: atrv1/go_to_waypoint pursues another goal", 1))
        .as("%s", follow.status())
        .isTrue();
    assertThat(robot.time.until(() -> robot.distanceTo(0, -8) < 0.5, 60)).isTrue();
    assertThat(goTo.status().goal()).as("nobody took it away").isEqualTo(mine);
    assertThat(robot.reaches(follow, Phase.SUCCEEDED, 120)).as("%s", follow.status()).isTrue();
  }

  @Test
  void waitsWhereAnotherGoalHasTakenThePlaceOfItsLeg() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    FollowWaypointsImpl follow = addFollow();
    UUID unused = follow.pursue(THREE);
    robot.time.step(2);
    goTo.cancel(); // and in the same instant, before follow_waypoints has looked:
    UUID mine = goTo.pursue(new LegGoal(null, at(3, -3), 0.4));
    assertThat(
            robot.reachesActivity(follow, "it waits: atrv1/go_to_waypoint pursues another goal", 1))
        .isTrue();
    assertThat(goTo.status().goal()).isEqualTo(mine);
    assertThat(robot.reaches(follow, Phase.SUCCEEDED, 120)).as("%s", follow.status()).isTrue();
  }

  @Test
  void isCancelledWithItsLegAndReportsWhy() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    FollowWaypointsImpl follow = addFollow();
    UUID unused = follow.pursue(THREE);
    robot.time.step(2);
    goTo.cancel();
    assertThat(robot.reaches(follow, Phase.CANCELLED, 1)).isTrue();
    assertThat(follow.status().activity())
        .isEqualTo("its leg was cancelled: a client cancelled it");
  }

  @Test
  void pausesAndResumesWithItsLeg() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    FollowWaypointsImpl follow = addFollow();
    UUID goal = follow.pursue(THREE);
    robot.time.step(4);
    follow.pause();
    assertThat(goTo.status().phase()).isEqualTo(Phase.CANCELLED);
    double stood = robot.east;
    robot.time.step(5);
    assertThat(robot.east).isEqualTo(stood);
    follow.resume();
    assertThat(robot.reaches(follow, Phase.SUCCEEDED, 90)).as("%s", follow.status()).isTrue();
    assertThat(follow.status().goal()).isEqualTo(goal);
  }

  @Test
  void refusesAPathWithAWaypointOutOfReachBeforeAnythingMoves() {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    FollowWaypointsImpl follow = addFollow();
    PathGoal far = new PathGoal(null, List.of(at(6, 0), new GeoPosition(11, 48, 0)), 0.4);
    assertThatThrownBy(() -> follow.pursue(far))
        .isInstanceOf(GoalRefusedException.class)
        .hasMessageContaining("the waypoint 11.0000000°,48.0000000° is")
        .hasMessageContaining("km from the one before it, 48.0000000°,11.000080")
        .hasMessageEndingWith("see that latitude and longitude are not swapped");
    robot.time.step(2);
    assertThat(robot.drive.velocities).as("%s", goTo.status()).isEmpty();
    assertThat(follow.status().phase()).isEqualTo(Phase.IDLE);
  }

  @Test
  void saysWhatIsMissingBeforeAnythingMoves() {
    FollowWaypointsImpl follow = addFollow();
    assertThatThrownBy(() -> follow.pursue(THREE))
        .isInstanceOf(NotReadyException.class)
        .hasMessageEndingWith(
            "it needs a GoToWaypoint on atrv1, and there is none; add one to the robot's XML");
  }
}
