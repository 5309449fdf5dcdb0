package org.dfra.autonomy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;

import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.UUID;
import java.util.stream.Collectors;
import org.dfra.agent.HelpCall;
import org.dfra.agent.HelpCallRejectedException;
import org.dfra.agent.RecruitmentAgent;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.agent.RequesterPhase;
import org.dfra.agent.ResponderPhase;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.GoToWaypoint;
import org.dfra.core.config.RobotXml;
import org.dfra.directory.ModuleQuery;
import org.dfra.flow.perceptual.PositionEstimator;
import org.dfra.module.NotReadyException;
import org.dfra.persona.RecruitmentAttributes;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.proxy.effector.DriveProxy;
import org.dfra.river.proxy.sensor.GPSProxy;
import org.dfra.river.proxy.sensor.OdometryProxy;
import org.dfra.river.proxy.sensor.RangeProxy;
import org.dfra.river.server.ModuleServer;
import org.dfra.river.server.effector.DriveServer;
import org.dfra.river.server.sensor.GPSServer;
import org.dfra.river.server.sensor.OdometryServer;
import org.dfra.river.server.sensor.RangeServer;
import org.dfra.robot.RunningPhoenix;
import org.dfra.testing.EmbeddedReggie;
import org.dfra.testing.ServedModule;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/**
 * A helper in processes of its own, whose agent is killed on its way: it goes on, and arrives. The
 * tests share the helper's body; each brings it up with an agent of other parameters, and its way
 * begins where the one before has ended it.
 */
@Timeout(300)
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class RecruitmentAgentsIT {

  private static final Duration PATIENCE = Duration.ofSeconds(90);

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  private static final Path PROPERTIES =
      Path.of(System.getProperty("dfra.root"), "config", "modules");

  /** Farther than it gets within any of the leases of these tests. */
  private static final HelpCall FAR =
      new HelpCall("mine", SmallRobot.at(90, 0), Duration.ofMinutes(5), Duration.ofMinutes(3));

  @TempDir static Path folder;
  private static RunningPhoenix phoenix;

  @BeforeAll
  static void startPhoenix() throws Exception {
    phoenix = RunningPhoenix.start(folder.resolve("phoenix"));
  }

  @AfterAll
  static void endPhoenix() throws Exception {
    try (RunningPhoenix ended = phoenix) {
      assertThat(ended).isNotNull();
    }
  }

  /** Brings it up, or only its agent again if its body is up. */
  private static void up(String name, Map<String, String> ofAgent) throws Exception {
    try {
      assertThat(new RobotBootstrap(phoenix.process(), RobotXml.read(robot(name, ofAgent))).up())
          .hasSize(10);
    } finally {
      phoenix.note();
    }
  }

  private static String module(String name, String properties, String parameters) {
    return "<module name=\"%s\" properties=\"%s.properties\">%s</module>%n"
        .formatted(name, PROPERTIES.resolve(properties), parameters);
  }

  private static String parameter(String name, String value) {
    return "<parameter name=\"%s\" value=\"%s\"/>".formatted(name, value);
  }

  /** One of the robot's body, which is no device. */
  private static String body(String name, Class<?> server, Class<?> proxy, Class<?> driver) {
    return "<module name=\"%s\" server=\"%s\" proxy=\"%s\" implementation=\"%s\"/>%n"
        .formatted(name, server.getName(), proxy.getName(), driver.getName().replace("$", "$$"));
  }

  private static Path robot(String name, Map<String, String> ofAgent) throws Exception {
    Map<String, String> parameters = new TreeMap<>(Map.of("percepts", "mine", "tolerance", "0.6"));
    parameters.putAll(ofAgent);
    return Files.writeString(
        folder.resolve(name + ".xml"),
        "<robot xmlns=\"urn:dfra:robot:1\" name=\"%s\" host=\"127.0.0.1\">\n".formatted(name)
            + "<lookup locators=\"127.0.0.1:"
            + REGGIE.port()
            + "\"/>\n<group name=\"body\">\n"
            + body("odometry", OdometryServer.class, OdometryProxy.class, SmallRobot.Counter.class)
            + body("gps", GPSServer.class, GPSProxy.class, SmallRobot.Receiver.class)
            + body("laser", RangeServer.class, RangeProxy.class, SmallRobot.Laser.class)
            + body("drive", DriveServer.class, DriveProxy.class, SmallRobot.Wheels.class)
            + module("range_filter", "range-filter", "")
            + module(
                "position",
                "position-estimator",
                parameter("initial_yaw", "0") + parameter("gps_bias_sigma", "0"))
            + module("heading_error", "heading-error", "")
            + module("fuzzy_drive", "fuzzy-drive", "")
            + module("go_to_waypoint", "go-to-waypoint", "")
            + "</group>\n<group name=\"agent\">\n"
            + module(
                "agent",
                "recruitment-agent",
                parameters.entrySet().stream()
                    .map(each -> parameter(each.getKey(), each.getValue()))
                    .collect(Collectors.joining()))
            + "</group>\n</robot>\n");
  }

  private static RecruitmentAgent agent(JiniModuleDirectory directory, String robot)
      throws Exception {
    return directory
        .findFirst(ModuleQuery.of(RecruitmentAgent.class).robot(robot), PATIENCE)
        .orElseThrow(() -> new AssertionError(robot + " has no agent"))
        .module();
  }

  @Test
  @Order(1) // its way is short, and begins where the robot stands at first
  void aHelperWhoseAgentIsKilledOnItsWayGoesOn() throws Exception {
    ServedModule<?> uav =
        ServedModule.fromProperties(folder, "agent", "recruitment-agent", Map.of())
            .on("uav")
            .joining(REGGIE);
    try (ModuleServer<?> serving = uav.serve();
        JiniModuleDirectory directory = REGGIE.directory()) {
      up("robot", Map.of());
      RecruitmentAgent asking = agent(directory, "uav");
      assertThat(asking.identification()).as("%s", serving).isNotNull();
      RecruitmentAgent helping = agent(directory, "robot");
      assertThat(helping.awaitReadiness(PATIENCE).serves()).isTrue();
      HelpCall call =
          new HelpCall("mine", SmallRobot.at(9, 0), Duration.ofMinutes(5), Duration.ofMinutes(3));
      await().atMost(PATIENCE).until(() -> isMade(asking, call));
      await()
          .atMost(PATIENCE)
          .until(() -> helping.status().responderPhase() == ResponderPhase.TRAVELLING);

      phoenix.kill("robot.agent");

      assertThat(phase(helping)).as("the same proxy, after kill -9").isNotNull();
      await().atMost(PATIENCE).until(() -> phase(helping) == ResponderPhase.LEASED);
      await()
          .atMost(PATIENCE)
          .until(() -> asking.status().requesterPhase() == RequesterPhase.BEING_HELPED);
      assertThat(asking.status().helperRobot()).isEqualTo("robot");
      assertThat(helping.status().helpedRobot()).isEqualTo("uav");
      assertThat(position(directory)).as("metres from the place").isCloseTo(0, within(1.2));

      asking.release();
      await().atMost(PATIENCE).until(() -> phase(helping) == ResponderPhase.FREE);
    }
  }

  private static boolean isMade(RecruitmentAgent asking, HelpCall call) throws RemoteException {
    try {
      asking.callForHelp(call);
      return true;
    } catch (HelpCallRejectedException e) {
      assertThat(e).hasMessageContaining("no robot within reach"); // it has not seen the other yet
      return false;
    }
  }

  /** What the helper is at, once its next process answers. */
  private static ResponderPhase phase(RecruitmentAgent helping) {
    ResponderPhase[] found = new ResponderPhase[1];
    await()
        .atMost(PATIENCE)
        .until(
            () -> {
              try {
                found[0] = helping.status().responderPhase();
                return helping.readiness().serves();
              } catch (RemoteException | NotReadyException e) {
                return false;
              }
            });
    return found[0];
  }

  /** Somebody steps in front of a helper and has it stop; then its agent's process dies. */
  @Test
  @Order(2)
  void aHelperThatSomebodyStoppedAnswersNoCallUntilAPersonLetsItGoOn() throws Exception {
    ServedModule<?> uav =
        ServedModule.fromProperties(folder, "agent", "recruitment-agent", Map.of())
            .on("uav")
            .joining(REGGIE);
    try (ModuleServer<?> serving = uav.serve();
        JiniModuleDirectory directory = REGGIE.directory()) {
      up("robot", Map.of("strategy", "greedy", "speed", "1"));
      RecruitmentAgent asking = agent(directory, "uav");
      assertThat(asking.identification()).as("%s", serving).isNotNull();
      RecruitmentAgent helping = agent(directory, "robot");
      assertThat(helping.awaitReadiness(PATIENCE).serves()).isTrue();
      GoToWaypoint driving = driving(directory, "robot");
      await().atMost(PATIENCE).until(() -> isMade(asking, FAR));
      await()
          .atMost(PATIENCE)
          .until(() -> helping.status().responderPhase() == ResponderPhase.TRAVELLING);
      await().atMost(PATIENCE).until(() -> driving.status().phase() == Phase.RUNNING);

      driving.pause();

      await()
          .atMost(PATIENCE)
          .until(() -> helping.status().responderPhase() == ResponderPhase.FREE);
      assertThat(helping.status().holdReason()).contains("robot/go_to_waypoint");
      await().atMost(PATIENCE).until(() -> isShownAsHeld(directory));
      phoenix.kill("robot.agent");
      assertThat(phase(helping)).isEqualTo(ResponderPhase.FREE);
      await("that the next process knows it too, perhaps only from the behaviour")
          .atMost(PATIENCE)
          .untilAsserted(
              () ->
                  assertThat(helping.status().holdReason())
                      .isNotNull()
                      .contains("robot/go_to_waypoint"));
      List<RecruitmentStatus> statuses = ServedRobots.received(helping, RecruitmentStatus.class);
      int calls = 3;
      await()
          .atMost(PATIENCE)
          .until(
              () ->
                  asking.status().requesterPhase() == RequesterPhase.CALLING
                      || isMade(asking, FAR));
      await("that it answers no call, in the time in which it would")
          .during(Duration.ofSeconds(calls))
          .atMost(PATIENCE)
          .until(
              () ->
                  statuses.stream().allMatch(each -> each.responderPhase() == ResponderPhase.FREE));
      assertThat(helping.status().responderPhase()).isEqualTo(ResponderPhase.FREE);
      assertThat(driving.status().phase()).isEqualTo(Phase.CANCELLED);

      helping.resume();

      assertThat(helping.status().holdReason()).isNull();
      await()
          .atMost(PATIENCE)
          .until(() -> helping.status().responderPhase() == ResponderPhase.TRAVELLING);
      asking.release();
      await().atMost(PATIENCE).until(() -> phase(helping) == ResponderPhase.FREE);
    }
  }

  /** Long, since a lease of the task has to end, and another helper has to be asked. */
  @Test
  @Order(3) // it brings up another robot, which would answer the others' calls
  @EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "takes a minute")
  void aHelperWhoseAgentIsSuspendedOnItsWayIsNeverOneOfTwo() throws Exception {
    Map<String, String> quick = Map.of("replace_after", "6", "help_every", "1");
    ServedModule<?> uav =
        ServedModule.fromProperties(folder, "agent", "recruitment-agent", quick)
            .on("uav")
            .joining(REGGIE);
    try (ModuleServer<?> serving = uav.serve();
        JiniModuleDirectory directory = REGGIE.directory()) {
      for (Map.Entry<String, String> each : Map.of("robot", "20", "other", "4").entrySet()) {
        Map<String, String> ofAgent = new TreeMap<>(quick);
        ofAgent.put("strategy", "greedy");
        ofAgent.put("speed", each.getValue()); // the nearer one by its own word is chosen
        up(each.getKey(), ofAgent);
      }
      RecruitmentAgent asking = agent(directory, "uav");
      assertThat(asking.identification()).as("%s", serving).isNotNull();
      RecruitmentAgent first = agent(directory, "robot");
      RecruitmentAgent second = agent(directory, "other");
      GoToWaypoint driving = driving(directory, "robot");
      assertThat(first.awaitReadiness(PATIENCE).serves()).isTrue();
      assertThat(second.awaitReadiness(PATIENCE).serves()).isTrue();
      await().atMost(PATIENCE).until(() -> isOnItsWay(asking, first, second));
      await().atMost(PATIENCE).until(() -> driving.status().phase() == Phase.RUNNING);
      long pid = phoenix.group("robot.agent").pid();
      signal("-STOP", pid);
      try {
        await()
            .pollInterval(Duration.ofMillis(50))
            .atMost(PATIENCE)
            .until(
                () -> {
                  boolean isSecond = second.status().responderPhase().isCommitted();
                  boolean isMoving = driving.status().phase() == Phase.RUNNING;
                  assertThat(isSecond && isMoving).as("two helpers").isFalse();
                  return isSecond;
                });
        assertThat(driving.status().phase()).as("its lease ended it").isEqualTo(Phase.FAILED);
        assertThat(driving.status().activity()).contains("time limit");
      } finally {
        signal("-CONT", pid);
      }
      UUID leg = driving.status().goal();
      await().atMost(PATIENCE).until(() -> phase(first) == ResponderPhase.FREE);
      assertThat(second.status().responderPhase().isCommitted()).isTrue();
      assertThat(asking.status().helperRobot()).isEqualTo("other");
      assertThat(driving.status().goal()).as("it has begun nothing since").isEqualTo(leg);
      asking.release();
      await().atMost(PATIENCE).until(() -> phase(second) == ResponderPhase.FREE);
    }
  }

  /** Has the first of two chosen, though the second may be found before it. */
  private static boolean isOnItsWay(
      RecruitmentAgent asking, RecruitmentAgent first, RecruitmentAgent second)
      throws RemoteException {
    if (second.status().responderPhase().isCommitted()) {
      asking.release();
    } else if (asking.status().requesterPhase() == RequesterPhase.IDLE
        && second.status().responderPhase() == ResponderPhase.FREE) {
      boolean unused = isMade(asking, FAR);
    }
    return first.status().responderPhase() == ResponderPhase.TRAVELLING;
  }

  private static GoToWaypoint driving(JiniModuleDirectory directory, String robot)
      throws Exception {
    return directory
        .findFirst(ModuleQuery.of(GoToWaypoint.class).robot(robot), PATIENCE)
        .orElseThrow(() -> new AssertionError(robot + " has nothing that drives"))
        .module();
  }

  /** By its persona. */
  private static boolean isShownAsHeld(JiniModuleDirectory directory) {
    return directory.find(ModuleQuery.of(RecruitmentAgent.class).robot("robot")).stream()
        .flatMap(each -> each.attributes(RecruitmentAttributes.class).stream())
        .anyMatch(each -> each.holdReason() != null);
  }

  private static void signal(String name, long pid) throws Exception {
    assertThat(new ProcessBuilder("kill", name, Long.toString(pid)).start().waitFor()).isZero();
  }

  private static double position(JiniModuleDirectory directory) throws Exception {
    return directory
        .findFirst(ModuleQuery.of(PositionEstimator.class).robot("robot"), PATIENCE)
        .orElseThrow()
        .module()
        .estimate()
        .position()
        .groundDistance(SmallRobot.at(9, 0));
  }
}
