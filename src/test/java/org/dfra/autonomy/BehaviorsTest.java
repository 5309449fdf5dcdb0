package org.dfra.autonomy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.behavior.HomeGoal;
import org.dfra.behavior.LegGoal;
import org.dfra.behavior.PathGoal;
import org.dfra.behavior.RasterGoal;
import org.dfra.flow.motor.DriveAdvice;
import org.dfra.flow.perceptual.Clearance;
import org.dfra.flow.perceptual.HeadingPercept;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.Leg;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Module;
import org.dfra.module.NotReadyException;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.proxy.behavior.FollowWaypointsProxy;
import org.dfra.river.proxy.behavior.GoToWaypointProxy;
import org.dfra.river.proxy.behavior.RasterSearchProxy;
import org.dfra.river.proxy.behavior.ReturnHomeProxy;
import org.dfra.river.proxy.schema.FuzzyDriveProxy;
import org.dfra.river.proxy.schema.HeadingErrorProxy;
import org.dfra.river.proxy.schema.PositionEstimatorProxy;
import org.dfra.river.proxy.schema.RangeFilterProxy;
import org.dfra.testing.EmbeddedReggie;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/**
 * Schemas and behaviours as a robot's XML and the properties that come with DFRA describe them:
 * served, finding each other in a lookup service, called and listened to through the network.
 */
@Timeout(180)
class BehaviorsTest {

  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final LegGoal FAR = new LegGoal(null, SmallRobot.at(200, 0), 0.4);

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  @TempDir Path folder;

  private ServedRobots robots;

  @BeforeEach
  void begin() throws Exception {
    robots = new ServedRobots(folder, REGGIE, PATIENCE);
    robots.serveSmallRobot();
    robots.serve("follow_waypoints", "follow-waypoints", Map.of());
    robots.serve("return_home", "return-home", Map.of());
    robots.serve("raster_search", "raster-search", Map.of());
  }

  @AfterEach
  void end() {
    robots.close();
  }

  /** The module by the network, as anybody has it who is elsewhere. */
  private <P extends ModuleProxy<? extends Module>> P far(Class<P> type, String query)
      throws Exception {
    P near = type.cast(robots.find(query).module());
    return type.getConstructor(
            org.dfra.river.remote.RemoteModule.class,
            UUID.class,
            org.dfra.module.Identification.class)
        .newInstance(near.server(), UUID.randomUUID(), near.identification());
  }

  @Test
  void schemasAreFoundByTheirAttributesAndPublishTheirPerceptsThroughTheNetwork() throws Exception {
    RangeFilterProxy rangeFilter =
        far(
            RangeFilterProxy.class,
            "RangeFilter with perceptual_schema.percept = Clearance"
                + " and perceptual_schema.method = median");
    assertThat(rangeFilter.awaitReadiness(PATIENCE).serves()).isTrue();
    Clearance clearance = rangeFilter.clearance();
    assertThat(clearance.min()).isEqualTo(8);
    List<Clearance> clearances = ServedRobots.received(rangeFilter, Clearance.class);
    await().atMost(PATIENCE).until(() -> clearances.size() > 3);
    assertThat(clearances.get(0).frame()).isEqualTo("robot/base_link");

    PositionEstimatorProxy position =
        far(
            PositionEstimatorProxy.class,
            "PositionEstimator with perceptual_schema.uncertainty = covariance"
                + " and perceptual_schema.method = kalman");
    assertThat(position.awaitReadiness(PATIENCE).serves()).isTrue();
    List<PoseEstimate> poses = ServedRobots.received(position, PoseEstimate.class);
    await().atMost(PATIENCE).until(() -> poses.size() > 3);
    await().atMost(PATIENCE).until(() -> position.estimate().yawSigma() < 0.2);
    assertThat(position.estimate().yaw()).as("as it was configured").isCloseTo(0, within(0.3));

    HeadingErrorProxy guidance =
        far(HeadingErrorProxy.class, "HeadingError with perceptual_schema.method = lookahead");
    assertThat(guidance.awaitReadiness(PATIENCE).serves()).isTrue();
    List<HeadingPercept> headings = ServedRobots.received(guidance, HeadingPercept.class);
    HeadingPercept heading = guidance.towards(new Leg(SmallRobot.at(0, 0), SmallRobot.at(0, 10)));
    assertThat(heading.headingError()).as("to its left").isCloseTo(Math.PI / 2, within(0.4));
    await().atMost(PATIENCE).until(() -> headings.contains(heading));

    FuzzyDriveProxy rules =
        far(
            FuzzyDriveProxy.class,
            "FuzzyDrive with motor_schema.command = Velocity and motor_schema.rules >= 100");
    List<DriveAdvice> advices = ServedRobots.received(rules, DriveAdvice.class);
    DriveAdvice advice = rules.advise(clearance, heading);
    assertThat(advice.velocity().yawRate()).isPositive();
    await().atMost(PATIENCE).until(() -> advices.contains(advice));

    FuzzyDriveProxy near = (FuzzyDriveProxy) robots.find("FuzzyDrive").module();
    assertThat(near.advise(clearance, heading)).isEqualTo(advice);
    assertThat(rangeFilter.inputTypes()).containsExactly("Odometry", "RangeScan");
    rangeFilter.setInputs(List.of("robot/odometry", "robot/laser"));
    assertThat(rangeFilter.inputs()).containsExactly("robot/odometry", "robot/laser");
    assertThatThrownBy(() -> rangeFilter.setInputs(List.of("robot/odometry", "robot/gps")))
        .hasMessage(
            "robot/range_filter cannot be wired to robot/gps: it is not of type RangeSensor");
    int before = clearances.size();
    await().atMost(PATIENCE).until(() -> clearances.size() > before + 3);
  }

  @Test
  void aBehaviourIsPursuedPausedResumedAndCancelledFromElsewhere() throws Exception {
    GoToWaypointProxy goTo =
        far(
            GoToWaypointProxy.class,
            "GoToWaypoint with behavior.goal = LegGoal and behavior.script = false"
                + " and behavior.rate >= 10 and behavior.phase = IDLE");
    List<BehaviorStatus> reported = ServedRobots.received(goTo, BehaviorStatus.class);
    assertThat(goTo.status().phase()).isEqualTo(Phase.IDLE);
    UUID goal = pursue(goTo, FAR, GoToWaypointProxy::pursue);
    await().atMost(PATIENCE).until(() -> SmallRobot.east() > 1);
    assertThat(robots.find("Behavior with behavior.phase = RUNNING").name())
        .isEqualTo("go_to_waypoint");

    goTo.pause();
    double stood = SmallRobot.east();
    assertThat(goTo.status().phase()).isEqualTo(Phase.PAUSED);
    assertThat(robots.find("GoToWaypoint with behavior.phase = PAUSED").name()).isNotNull();
    assertThat(SmallRobot.east()).isEqualTo(stood);
    assertThatThrownBy(() -> goTo.pursue(FAR))
        .isInstanceOfSatisfying(GoalRefusedException.class, e -> assertThat(e.isBusy()).isTrue())
        .hasMessageContaining("robot/go_to_waypoint pursues another goal (a client paused it)");
    goTo.resume();
    await().atMost(PATIENCE).until(() -> SmallRobot.east() > stood + 0.5);
    goTo.cancel();
    assertThat(goTo.status().phase()).isEqualTo(Phase.CANCELLED);
    await()
        .atMost(PATIENCE)
        .until(() -> reported.stream().anyMatch(each -> each.phase() == Phase.CANCELLED));
    assertThat(reported).allMatch(each -> goal.equals(each.goal()));
    assertThat(reported.stream().map(BehaviorStatus::phase).distinct())
        .containsExactly(Phase.RUNNING, Phase.PAUSED, Phase.CANCELLED);
  }

  @Test
  void behavioursWorkForEachOtherAndARefusalCrossesTheNetworkAsItself() throws Exception {
    FollowWaypointsProxy follow =
        far(FollowWaypointsProxy.class, "FollowWaypoints with behavior.goal = PathGoal");
    PathGoal lost = new PathGoal(null, List.of(new GeoPosition(57, 11, 0)), 0.4);
    await()
        .atMost(PATIENCE)
        .untilAsserted(
            () ->
                assertThatThrownBy(() -> follow.pursue(lost))
                    .isInstanceOfSatisfying(
                        GoalRefusedException.class, e -> assertThat(e.isBusy()).isFalse())
                    .hasMessageContaining("km from the robot at"));
    RasterSearchProxy search =
        far(
            RasterSearchProxy.class,
            "RasterSearch with behavior.goal = RasterGoal and behavior.script = true");
    assertThatThrownBy(
            () ->
                search.pursue(
                    new RasterGoal(List.of(SmallRobot.at(1, 1), SmallRobot.at(2, 2)), 2, 1, false)))
        .isInstanceOf(GoalRefusedException.class);

    List<BehaviorStatus> reported = ServedRobots.received(follow, BehaviorStatus.class);
    PathGoal two = new PathGoal(null, List.of(SmallRobot.at(2, 0), SmallRobot.at(4, 0)), 0.5);
    UUID goal = pursue(follow, two, FollowWaypointsProxy::pursue);
    await()
        .atMost(PATIENCE.multipliedBy(2))
        .until(() -> reported.stream().anyMatch(each -> each.phase() == Phase.SUCCEEDED));
    assertThat(follow.status().goal()).isEqualTo(goal);
    assertThat(SmallRobot.east()).isGreaterThan(3);

    ReturnHomeProxy back = far(ReturnHomeProxy.class, "ReturnHome with behavior.goal = HomeGoal");
    UUID unused = pursue(back, new HomeGoal(1), ReturnHomeProxy::pursue);
    assertThat(back.status().phase()).isEqualTo(Phase.RUNNING);
    back.cancel();
    assertThat(back.status().phase()).isEqualTo(Phase.CANCELLED);
  }

  /** As soon as what it needs is found and ready. */
  @FunctionalInterface
  private interface Pursuing<P, G> {
    UUID begin(P behavior, G goal) throws Exception;
  }

  private static <P, G> UUID pursue(P behavior, G goal, Pursuing<P, G> how) {
    UUID[] begun = new UUID[1];
    await()
        .atMost(PATIENCE)
        .until(
            () -> {
              try {
                begun[0] = how.begin(behavior, goal);
                return true;
              } catch (NotReadyException e) {
                return false;
              }
            });
    return begun[0];
  }

  @Test
  void aSchemaThatIsNamedButMissingIsReportedWithFileAndLine() throws Exception {
    robots.serve("other_goer", "go-to-waypoint", Map.of("range_filter", "sonar_filter"));
    GoToWaypointProxy goTo = far(GoToWaypointProxy.class, "GoToWaypoint named other_goer");
    assertThatThrownBy(() -> goTo.pursue(FAR))
        .isInstanceOf(NotReadyException.class)
        .hasMessage(
            "robot/other_goer is INITIALIZING: it needs a RangeFilter named sonar_filter on robot,"
                + " and there is none; "
                + folder.resolve("other_goer.xml")
                + ":4 names it");
    robots.serve("other_filter", "range-filter", Map.of("range_sensor", "sonar"));
    RangeFilterProxy filter = far(RangeFilterProxy.class, "RangeFilter named other_filter");
    assertThat(filter.readiness()).isEqualTo(Readiness.INITIALIZING);
    await()
        .atMost(PATIENCE)
        .untilAsserted(
            () ->
                assertThatThrownBy(filter::clearance)
                    .hasMessage(
                        "robot/other_filter is INITIALIZING: it awaits its first Clearance; there"
                            + " is no RangeSensor named sonar on robot, which "
                            + folder.resolve("other_filter.xml")
                            + ":4 names"));
  }

  @Test
  void whenAllHaveEndedNoThreadOfTheirsIsLeft() throws Exception {
    RangeFilterProxy rangeFilter = (RangeFilterProxy) robots.find("RangeFilter").module();
    assertThat(rangeFilter.awaitReadiness(PATIENCE).serves()).isTrue();
    GoToWaypointProxy goTo = far(GoToWaypointProxy.class, "GoToWaypoint");
    UUID unused = pursue(goTo, FAR, GoToWaypointProxy::pursue);
    await().atMost(PATIENCE).until(() -> SmallRobot.east() > 0.3);
    robots.close();
    double stood = SmallRobot.east();
    await()
        .atMost(PATIENCE)
        .untilAsserted(
            () ->
                assertThat(Thread.getAllStackTraces().keySet())
                    .extracting(Thread::getName)
                    .noneMatch(
                        name ->
                            name.matches(
                                "dfra-(behavior|inputs|errands|directory-watchdog|registrar|locator).*")));
    assertThat(SmallRobot.east()).isEqualTo(stood);
  }
}
