package org.dfra.behaviors.waypoint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.behaviors.ScriptedRobot.at;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.LegGoal;
import org.dfra.behavior.PathGoal;
import org.dfra.behavior.RasterGoal;
import org.dfra.behaviors.ScriptedRobot;
import org.dfra.behaviors.raster.RasterSearchImpl;
import org.dfra.core.behavior.BehaviorImpl;
import org.dfra.core.behavior.DriveInterlock;
import org.dfra.core.behavior.GoalExecution;
import org.dfra.core.behavior.GoalProgress;
import org.dfra.core.module.ModuleContext;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.DriveCommand.Brake;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.module.NotReadyException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A brake that was set, or a stop that is released, never makes a robot drive by itself. */
@Timeout(120)
class BrakeTest {

  private static final LegGoal TEN_METRES = new LegGoal(null, at(10, 0), 0.4);
  private static final PathGoal PATH = new PathGoal(null, List.of(at(4, 0), at(8, 0)), 0.4);
  private static final RasterGoal FIELD =
      new RasterGoal(List.of(at(1, 1), at(7, 1), at(7, 9), at(1, 9)), 2, 1.6, false);

  private final ScriptedRobot robot = new ScriptedRobot();
  private GoToWaypointImpl goTo;

  @BeforeEach
  void begin() {
    goTo = robot.addGoTo(Map.of());
  }

  @AfterEach
  void end() {
    robot.close();
  }

  private FollowWaypointsImpl addFollow() {
    return robot.add(new FollowWaypointsImpl(robot.context("follow_waypoints", Map.of())));
  }

  private RasterSearchImpl addSearch() {
    return robot.add(new RasterSearchImpl(robot.context("raster_search", Map.of())));
  }

  /** Drives some way; nothing needs a brake to be released so far. */
  private void drive() {
    double east = robot.east;
    assertThat(robot.time.until(() -> robot.east > east + 1, 30)).isTrue();
    assertThat(robot.drive.braked).isEmpty();
  }

  private void staysPausedByTheBrake(BehaviorImpl<?> behavior) {
    assertThat(robot.reaches(behavior, Phase.PAUSED, 2)).as("%s", behavior.status()).isTrue();
    assertThat(behavior.status().activity()).contains("atrv1/drive has its brake set");
    staysWhereItIs();
    assertThat(behavior.status().phase()).isEqualTo(Phase.PAUSED);
  }

  private void staysWhereItIs() {
    double east = robot.east;
    double north = robot.north;
    robot.time.step(20);
    assertThat(robot.distanceTo(east, north)).isZero();
    assertThat(robot.drive.braked).as("nobody has released it").doesNotContain(false);
    assertThat(robot.drive.turning).isEqualTo(Velocity.ZERO);
  }

  @Test
  void aBrakeThatIsSetOnTheWayPausesTheGoalUntilSomebodyResumesIt() throws Exception {
    UUID goal = goTo.pursue(TEN_METRES);
    drive();
    robot.drive.switchBrake(true);
    staysPausedByTheBrake(goTo);
    goTo.resumeUnattended();
    staysPausedByTheBrake(goTo);
    goTo.resume();
    assertThat(robot.reaches(goTo, Phase.SUCCEEDED, 60)).as("%s", goTo.status()).isTrue();
    assertThat(robot.drive.braked).containsExactly(false);
    assertThat(goTo.status().goal()).isEqualTo(goal);
  }

  @Test
  void releasingTheBrakeDoesNotMoveTheRobot() throws Exception {
    UUID unused = goTo.pursue(TEN_METRES);
    drive();
    robot.drive.switchBrake(true);
    assertThat(robot.reaches(goTo, Phase.PAUSED, 2)).isTrue();
    robot.drive.switchBrake(false);
    staysWhereItIs();
  }

  @Test
  void aNewLeaseReleasesNoBrake() throws Exception {
    UUID unused = goTo.pursue(TEN_METRES);
    drive();
    robot.drive.switchBrake(true);
    robot.drive.leases().leases().forEach(lease -> robot.drive.leases().revoke(lease.handle()));
    staysPausedByTheBrake(goTo);
  }

  @Test
  void aControllerThatIsSwitchedOffAndOnIsNotDrivenOn() throws Exception {
    UUID unused = goTo.pursue(TEN_METRES);
    drive();
    robot.drive.switchOff();
    assertThat(robot.reachesActivity(goTo, "it waits: atrv1/drive is INITIALIZING", 2)).isTrue();
    robot.drive.switchOn();
    staysPausedByTheBrake(goTo);
  }

  @Test
  void theBrakeIsReleasedWhereAGoalIsAskedForAndNotWhereAProgramActsByItself() throws Exception {
    robot.drive.switchBrake(true);
    UUID unattended = goTo.pursueUnattended(TEN_METRES);
    staysPausedByTheBrake(goTo);
    goTo.cancel(unattended);
    UUID unused = goTo.pursue(TEN_METRES);
    assertThat(robot.drive.braked).as("before the call returns").containsExactly(false);
    assertThat(robot.reaches(goTo, Phase.SUCCEEDED, 60)).as("%s", goTo.status()).isTrue();
  }

  @Test
  void aBrakeThatIsSetWhileTheGoalWaitsIsNotReleased() throws Exception {
    robot.seesRoom = false;
    robot.time.step(1);
    robot.drive.switchBrake(true);
    UUID unused = goTo.pursue(TEN_METRES);
    assertThat(robot.drive.braked).containsExactly(false);
    robot.drive.braked.clear();
    assertThat(robot.reachesActivity(goTo, "it waits: atrv1/range_filter", 1)).isTrue();
    robot.drive.switchBrake(true);
    robot.seesRoom = true;
    staysPausedByTheBrake(goTo);
  }

  @Test
  void anEmergencyStopEndsAGoalThatWaitedMeanwhile() throws Exception {
    UUID unused = goTo.pursue(TEN_METRES);
    drive();
    robot.seesRoom = false;
    assertThat(robot.reachesActivity(goTo, "it waits: atrv1/range_filter", 1)).isTrue();
    Object stopped = robot.drive.emergencyStop("a test");
    Object released = robot.drive.releaseEmergencyStop("a test");
    robot.time.step(1);
    robot.seesRoom = true;
    assertThat(robot.reaches(goTo, Phase.CANCELLED, 2))
        .as("%s %s %s", stopped, released, goTo.status())
        .isTrue();
    assertThat(goTo.status().activity())
        .contains("its drive was stopped for an emergency after the goal was begun");
    staysWhereItIs();
    UUID again = goTo.pursue(TEN_METRES);
    assertThat(again).isNotNull();
    assertThat(robot.reaches(goTo, Phase.SUCCEEDED, 60)).as("%s", goTo.status()).isTrue();
  }

  @Test
  void anEmergencyStopEndsAPathThatWaitedForWhatDrivesIt() throws Exception {
    FollowWaypointsImpl follow = addFollow();
    UUID unused = follow.pursue(PATH);
    drive();
    robot.end(goTo);
    assertThat(robot.reachesActivity(follow, "it waits: atrv1/go_to_waypoint", 1)).isTrue();
    Object stopped = robot.drive.emergencyStop("a test");
    Object released = robot.drive.releaseEmergencyStop("a test");
    goTo = robot.addGoTo(Map.of());
    assertThat(robot.reaches(follow, Phase.CANCELLED, 2))
        .as("%s %s %s", stopped, released, follow.status())
        .isTrue();
    staysWhereItIs();
  }

  @Test
  void theNextLegReleasesNoBrake() throws Exception {
    FollowWaypointsImpl follow = addFollow();
    UUID unused = follow.pursue(PATH);
    assertThat(robot.time.until(() -> goTo.status().phase() == Phase.SUCCEEDED, 60)).isTrue();
    robot.drive.switchBrake(true); // between two legs
    staysPausedByTheBrake(follow);
    assertThat(goTo.status().phase()).isEqualTo(Phase.CANCELLED);
    follow.resume();
    assertThat(robot.reaches(follow, Phase.SUCCEEDED, 60)).as("%s", follow.status()).isTrue();
    assertThat(robot.drive.braked).containsExactly(false);
  }

  @Test
  void aSearchIsPausedByTheBrakeAndGoesOnWhenSomebodyResumesIt() throws Exception {
    FollowWaypointsImpl follow = addFollow();
    RasterSearchImpl search = addSearch();
    robot.drive.switchBrake(true);
    UUID unused = search.pursue(FIELD);
    assertThat(robot.drive.braked).containsExactly(false);
    robot.drive.braked.clear();
    assertThat(robot.reachesActivity(search, "lane 2 of ", 300)).isTrue();
    robot.drive.switchBrake(true);
    staysPausedByTheBrake(search);
    assertThat(follow.status().phase()).isEqualTo(Phase.CANCELLED);
    search.resumeUnattended();
    staysPausedByTheBrake(search);
    search.resume();
    assertThat(robot.reaches(search, Phase.SUCCEEDED, 300)).as("%s", search.status()).isTrue();
  }

  @Test
  void theNextProcessOfASearchReleasesNoBrake() throws Exception {
    FollowWaypointsImpl follow = addFollow();
    RasterSearchImpl first = addSearch();
    UUID unused = first.pursue(FIELD);
    assertThat(robot.reachesActivity(first, "lane 2 of ", 300)).isTrue();
    byte[] kept = robot.states.get("raster_search").read("raster").orElseThrow();
    robot.end(first);
    robot.end(follow); // all of its group
    robot.states.get("raster_search").write("raster", kept);
    robot.drive.switchBrake(true);
    follow = addFollow();
    RasterSearchImpl second = addSearch();
    staysPausedByTheBrake(second);
  }

  @Test
  void theNextProcessOfASearchIsNotMovedByTheReleaseOfAStop() throws Exception {
    FollowWaypointsImpl follow = addFollow();
    RasterSearchImpl first = addSearch();
    UUID unused = first.pursue(FIELD);
    assertThat(robot.reachesActivity(first, "lane 2 of ", 300)).isTrue();
    byte[] kept = robot.states.get("raster_search").read("raster").orElseThrow();
    robot.end(first);
    robot.end(follow);
    robot.states.get("raster_search").write("raster", kept);
    Object stopped = robot.drive.emergencyStop("a test");
    Object released = robot.drive.releaseEmergencyStop("a test");
    follow = addFollow();
    RasterSearchImpl second = addSearch();
    assertThat(robot.reaches(second, Phase.PAUSED, 2))
        .as("%s %s %s", stopped, released, second.status())
        .isTrue();
    staysWhereItIs();
  }

  @Test
  void aGoalIsRefusedWhileNobodyKnowsWhetherTheBrakeIsSet() throws Exception {
    robot.drive.switchOff();
    assertThatThrownBy(() -> goTo.pursue(TEN_METRES))
        .isInstanceOf(NotReadyException.class)
        .hasMessage(
            "the drive of atrv1 is INITIALIZING: whether its brake is set is not known; ask again"
                + " when it serves");
    assertThat(goTo.status().phase()).isEqualTo(Phase.IDLE);
  }

  @Test
  void aGoalThatAPersonAsksForIsRefusedWhereTheWheelsAreNotFound() {
    FollowWaypointsImpl follow = addFollow();
    robot.hide(robot.drive);
    assertThatThrownBy(() -> follow.pursue(PATH))
        .isInstanceOf(NotReadyException.class)
        .hasMessageContaining("it needs a DriveEffector on atrv1");
    assertThat(follow.status().phase()).isEqualTo(Phase.IDLE);
    robot.show(robot.drive);
  }

  private void stopAndRelease() {
    Object stopped = robot.drive.emergencyStop("a test");
    Object released = robot.drive.releaseEmergencyStop("a test");
    assertThat(List.of(stopped, released)).doesNotContainNull();
  }

  @Test
  void anEmergencyStopEndsAGoalThatAProgramAskedForBeforeItsWheelsWereFound() throws Exception {
    stopAndRelease(); // before the goal: this one does not count
    robot.time.step(1);
    FollowWaypointsImpl follow = addFollow();
    robot.hide(robot.drive);
    UUID unused = follow.pursueUnattended(PATH);
    robot.time.step(1);
    stopAndRelease();
    robot.show(robot.drive);
    assertThat(robot.reaches(follow, Phase.CANCELLED, 2)).as("%s", follow.status()).isTrue();
    staysWhereItIs();
    robot.hide(robot.drive);
    UUID again = follow.pursueUnattended(PATH);
    robot.time.step(1);
    robot.show(robot.drive);
    assertThat(robot.reaches(follow, Phase.SUCCEEDED, 60)).as("%s", follow.status()).isTrue();
    assertThat(follow.status().goal()).isEqualTo(again);
  }

  @Test
  void whetherAStopIsLaterThanAGoalDoesNotDependOnAnyClock() throws Exception {
    FollowWaypointsImpl follow = addFollow();
    robot.setAhead("drive", Duration.ofHours(1));
    stopAndRelease(); // before the goal, and after it by the clocks
    robot.time.step(1);
    robot.hide(robot.drive);
    UUID unused = follow.pursueUnattended(PATH);
    robot.time.step(1);
    robot.show(robot.drive);
    assertThat(robot.reaches(follow, Phase.SUCCEEDED, 60)).as("%s", follow.status()).isTrue();
    robot.hide(robot.drive);
    UUID again = follow.pursueUnattended(PATH);
    robot.time.step(1);
    robot.setAhead("drive", Duration.ofHours(-1));
    stopAndRelease(); // after the goal, and before it by the clocks
    robot.show(robot.drive);
    assertThat(robot.reaches(follow, Phase.CANCELLED, 2)).as("%s", follow.status()).isTrue();
    assertThat(follow.status().goal()).isEqualTo(again);
    staysWhereItIs();
  }

  @Test
  void whatAGoalHasSeenOfItsWheelsIsNotForgottenWhereTheyAreNotFound() throws Exception {
    FollowWaypointsImpl follow = addFollow();
    UUID unused = follow.pursue(PATH);
    drive();
    follow.pause();
    robot.hide(robot.drive);
    stopAndRelease();
    follow.resume();
    robot.show(robot.drive);
    assertThat(robot.reaches(follow, Phase.CANCELLED, 2)).as("%s", follow.status()).isTrue();
    staysWhereItIs();
  }

  /** Pans, for all that the wheels need to know. */
  private static final class Camera extends BehaviorImpl<LegGoal> {

    Camera(ModuleContext context) {
      super(context, "pans a camera", "DFRA", "1", LegGoal.class, 10);
    }

    @Override
    protected GoalExecution startGoal(LegGoal goal) {
      return new GoalExecution() {
        @Override
        public GoalProgress step() {
          return GoalProgress.reached("it has panned");
        }

        @Override
        public void suspend() {}
      };
    }

    DriveInterlock wheels() {
      return interlock();
    }
  }

  @Test
  void aBehaviourThatDoesNotSayThatItMovesTheWheelsReleasesNoBrake() throws Exception {
    Camera camera = robot.add(new Camera(robot.context("camera", Map.of())));
    robot.drive.switchBrake(true);
    UUID unused = camera.pursue(TEN_METRES);
    assertThat(robot.reaches(camera, Phase.SUCCEEDED, 2)).isTrue();
    assertThat(robot.drive.braked).isEmpty();
    assertThatThrownBy(camera::wheels)
        .hasMessage("atrv1/camera uses the interlock of the wheels; have movesWheels return true");
  }

  @Test
  void theBrakeIsLeftToTheClientThatCommandsTheWheels() throws Exception {
    robot.drive.switchBrake(true);
    try (CommandLease other = robot.drive.acquireCommandLease(java.time.Duration.ofSeconds(10))) {
      UUID unused = goTo.pursue(TEN_METRES);
      robot.time.step(2);
      assertThat(robot.drive.braked).isEmpty();
      robot.drive.execute(other.key(), new Brake(false));
    }
    assertThat(robot.reaches(goTo, Phase.SUCCEEDED, 60)).as("%s", goTo.status()).isTrue();
  }
}
