package org.dfra.slice;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;

import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.Map;
import org.dfra.agent.HelpCall;
import org.dfra.agent.HelpRefusedException;
import org.dfra.agent.RecruitmentAgent;
import org.dfra.agent.RequesterPhase;
import org.dfra.agent.ResponderPhase;
import org.dfra.core.config.RobotXml;
import org.dfra.directory.ModuleQuery;
import org.dfra.flow.perceptual.PositionEstimator;
import org.dfra.module.NotReadyException;
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
import org.dfra.robot.LivingPhoenix;
import org.dfra.testing.EmbeddedReggie;
import org.dfra.testing.ServedModule;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** A helper in processes of its own, whose agent is killed on its way: it goes on, and arrives. */
@Timeout(300)
class RecruitmentAgentsIT {

  private static final Duration PATIENCE = Duration.ofSeconds(90);

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  private static final Path PROPERTIES =
      Path.of(System.getProperty("dfra.root"), "config", "modules");

  @TempDir Path folder;

  private static String module(String name, String properties, String parameters) {
    return "<module name=\"%s\" properties=\"%s.properties\">%s</module>%n"
        .formatted(name, PROPERTIES.resolve(properties), parameters);
  }

  private static String parameter(String name, String value) {
    return "<parameter name=\"%s\" value=\"%s\"/>".formatted(name, value);
  }

  /** One of the robot's body, which is no device. */
  private static String body(String name, Class<?> server, Class<?> proxy, Class<?> driver) {
    return "<module name=\"%s\" server=\"%s\" proxy=\"%s\" driver=\"%s\"/>%n"
        .formatted(name, server.getName(), proxy.getName(), driver.getName().replace("$", "$$"));
  }

  private Path robot() throws Exception {
    return Files.writeString(
        folder.resolve("ugv.xml"),
        "<robot xmlns=\"urn:dfra:robot:1\" name=\"robot\" host=\"127.0.0.1\">\n"
            + "<lookup locators=\"127.0.0.1:"
            + REGGIE.port()
            + "\"/>\n<group name=\"body\">\n"
            + body("odometry", OdometryServer.class, OdometryProxy.class, SmallRobot.Counter.class)
            + body("gps", GPSServer.class, GPSProxy.class, SmallRobot.Receiver.class)
            + body("laser", RangeServer.class, RangeProxy.class, SmallRobot.Laser.class)
            + body("drive", DriveServer.class, DriveProxy.class, SmallRobot.Wheels.class)
            + module("range_filter", "range-filter", "")
            + module(
                "position", "position", parameter("initial_yaw", "0") + parameter("gps_bias", "0"))
            + module("heading_error", "heading-error", "")
            + module("fuzzy_drive", "fuzzy-drive", "")
            + module("go_to_waypoint", "go-to-waypoint", "")
            + "</group>\n<group name=\"agent\">\n"
            + module(
                "agent",
                "recruitment-agent",
                parameter("percepts", "mine") + parameter("tolerance", "0.6"))
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
  void aHelperWhoseAgentIsKilledOnItsWayGoesOn() throws Exception {
    ServedModule<?> uav =
        ServedModule.written(folder, "agent", "recruitment-agent", Map.of())
            .on("uav")
            .joining(REGGIE);
    try (ModuleServer<?> serving = uav.serve();
        LivingPhoenix phoenix = LivingPhoenix.start(folder.resolve("phoenix"));
        JiniModuleDirectory directory = REGGIE.directory()) {
      assertThat(new RobotBootstrap(phoenix.process(), RobotXml.read(robot())).up()).hasSize(10);
      phoenix.note();
      RecruitmentAgent asking = agent(directory, "uav");
      assertThat(asking.identification()).as("%s", serving).isNotNull();
      RecruitmentAgent helping = agent(directory, "robot");
      assertThat(helping.awaitReadiness(PATIENCE).serves()).isTrue();
      HelpCall call =
          new HelpCall("mine", SmallRobot.at(9, 0), Duration.ofMinutes(5), Duration.ofMinutes(3));
      await().atMost(PATIENCE).until(() -> isMade(asking, call));
      await()
          .atMost(PATIENCE)
          .until(() -> helping.status().responder() == ResponderPhase.TRAVELLING);

      phoenix.kill("robot.agent");

      assertThat(phase(helping)).as("the same proxy, after kill -9").isNotNull();
      await().atMost(PATIENCE).until(() -> phase(helping) == ResponderPhase.LEASED);
      await().atMost(PATIENCE).until(() -> asking.status().requester() == RequesterPhase.DONE);
      assertThat(asking.status().helper()).isEqualTo("robot");
      assertThat(helping.status().helped()).isEqualTo("uav");
      assertThat(position(directory)).as("metres from the place").isCloseTo(0, within(1.2));

      asking.release();
      await().atMost(PATIENCE).until(() -> phase(helping) == ResponderPhase.FREE);
    }
  }

  private static boolean isMade(RecruitmentAgent asking, HelpCall call) throws RemoteException {
    try {
      asking.help(call);
      return true;
    } catch (HelpRefusedException e) {
      assertThat(e).hasMessageContaining("nobody in reach"); // it has not seen the other yet
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
                found[0] = helping.status().responder();
                return helping.readiness().serves();
              } catch (RemoteException | NotReadyException e) {
                return false;
              }
            });
    return found[0];
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
