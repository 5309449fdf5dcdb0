package org.dfra.core.config;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.ResourceLock;

/** Old names in a robot's XML, in properties and in recorded parameters. */
@ResourceLock("RenamedNames") // the receiver of its warnings is the process's
class RenamedNamesTest {

  private static final String DRIVE =
      "server=a.Server\nproxy=a.Proxy\nimplementation=org.dfra.drivers.drive.rflex.RflexDriveImpl\n";

  @TempDir private Path temp;

  private final List<String> warnings = new CopyOnWriteArrayList<>();

  @BeforeEach
  void collectWarnings() {
    RenamedNames.onWarning(warnings::add);
  }

  @AfterEach
  void warnInTheLog() {
    RenamedNames.logWarnings();
  }

  private RobotFolder folder() {
    return new RobotFolder(temp);
  }

  private List<String> warnings() {
    return warnings.stream().map(each -> each.replace(temp + "/", "")).toList();
  }

  private static String warning(String place, String what, String old, String now) {
    return place
        + ": "
        + what
        + " "
        + old
        + " is now called "
        + now
        + "; the old name works until the next release.";
  }

  @Test
  void oldNamesInXmlWorkAndEachIsReportedOnce() {
    RobotFolder folder =
        folder()
            .xml(
                "<group name=\"a\">",
                "<registrar classes=\"8090\" from=\"10.0.0.8\"/>",
                "<module name=\"own\" server=\"S\" proxy=\"P\"",
                "    driver=\"a.OwnDrive\">",
                "<parameter name=\"longest_silence\" value=\"0.2\"/>",
                "</module></group>");
    RobotDescription robot = folder.read();
    RegistrarDescription registrar = robot.groups().get(0).registrar().orElseThrow();
    assertThat(registrar.classServerPort()).isEqualTo(8090);
    assertThat(registrar.moduleHosts()).containsExactly("10.0.0.8");
    ModuleDescription module = robot.modules().get(0);
    assertThat(module.driverClass()).isEqualTo("a.OwnDrive");
    assertThat(module.parameters().all())
        .isEqualTo(
            Map.of(
                "command_timeout",
                new Parameters.Value(
                    "0.2", new SourceLocation(folder.path("robot.xml").toString(), 6))));
    assertThat(warnings())
        .containsExactlyInAnyOrder(
            warning("robot.xml:3", "the attribute", "classes", "class-server-port"),
            warning("robot.xml:3", "the attribute", "from", "module-hosts"),
            warning("robot.xml:5", "the attribute", "driver", "implementation"),
            warning("robot.xml:6", "the parameter", "longest_silence", "command_timeout"));
    folder.read();
    assertThat(warnings).as("read a second time").hasSize(4);
  }

  @Test
  void oldAndNewAttributeOfOneElementAreAFault() {
    assertThat(
            folder()
                .xml(
                    "<group name=\"a\">",
                    "<registrar classes=\"off\" class-server-port=\"8090\"/></group>")
                .complaints())
        .containsExactly(
            "robot.xml:3: <registrar> has class-server-port and its old name classes; delete classes");
  }

  @Test
  void namesThatWereNeverKnownAreFaultsAsBefore() {
    assertThat(folder().xml("<group name=\"a\"><registrar ports=\"1\"/></group>").complaints())
        .containsExactly(
            "robot.xml:2: the attribute ports is not known in <registrar>; did you mean \"port\"?");
  }

  @Test
  void oldKeysAndParametersOfPropertiesWork() {
    RobotFolder folder =
        folder()
            .properties(
                "server=a.Server\nproxy=a.Proxy\n"
                    + "driver=org.dfra.drivers.drive.rflex.RflexDriveImpl\n"
                    + "parameter.turn_acceleration=3\n")
            .module();
    ModuleDescription module = folder.readModule();
    assertThat(module.driverClass()).isEqualTo("org.dfra.drivers.drive.rflex.RflexDriveImpl");
    assertThat(module.parameters().text("yaw_acceleration")).isEqualTo("3");
    assertThat(warnings())
        .containsExactly(
            warning("gps.properties:3", "the key", "driver", "implementation"),
            warning("gps.properties:4", "the parameter", "turn_acceleration", "yaw_acceleration"));
  }

  @Test
  void oldAndNewInOneFileAreAFault() {
    assertThat(folder().properties(DRIVE + "driver=a.Other\n").module().complaints())
        .containsExactly(
            "gps.properties:4: the key \"implementation\" (driver is its old name) is written"
                + " twice, first in line 3; delete one");
    assertThat(
            folder()
                .properties(DRIVE + "parameter.max_turn_rate=1\nparameter.max_yaw_rate=2\n")
                .module()
                .complaints())
        .containsExactly(
            "gps.properties:4: the parameter max_turn_rate is the old name of max_yaw_rate, which"
                + " is set in line 5; delete this one");
    assertThat(
            folder()
                .properties(DRIVE)
                .module(
                    "<parameter name=\"max_yaw_rate\" value=\"1\"/>",
                    "<parameter name=\"max_turn_rate\" value=\"1\"/>")
                .complaints())
        .containsExactly(
            "robot.xml:5: the parameter max_turn_rate is the old name of max_yaw_rate, which is set"
                + " in line 4; delete this one");
  }

  @Test
  void theXmlOverridesAnOldNameOfTheProperties() {
    ModuleDescription module =
        folder()
            .properties(DRIVE + "parameter.longest_silence=0.3\n")
            .module("<parameter name=\"command_timeout\" value=\"0.1\"/>")
            .readModule();
    assertThat(module.parameters().all()).containsOnlyKeys("command_timeout");
    assertThat(module.parameters().text("command_timeout")).isEqualTo("0.1");
  }

  @Test
  void aParameterIsRenamedForItsOwnImplementationOnly() {
    String position = "org.dfra.behaviors.perceptual.pose.PositionEstimatorImpl";
    String agent = "org.dfra.recruit.agent.RecruitmentAgentImpl";
    assertThat(recorded(position, Map.of("window", "30", "method", "history")))
        .isEqualTo(Map.of("fix_window", "30", "method", "fix_window"));
    assertThat(recorded(agent, Map.of("window", "3"))).isEqualTo(Map.of("offer_window", "3"));
    assertThat(recorded("a.Own", Map.of("window", "3"))).isEqualTo(Map.of("window", "3"));
    assertThat(warnings)
        .containsOnlyOnce(
            warning("code", "the value of method", "history", "fix_window"),
            warning("code", "the parameter", "window", "offer_window"));
  }

  private static Map<String, String> recorded(String implementation, Map<String, String> texts) {
    Map<String, String> present = new HashMap<>();
    new ModuleDescription(
            "atrv1",
            "m",
            "S",
            "P",
            implementation,
            null,
            true,
            Parameters.of("atrv1/m", texts),
            SourceLocation.CODE)
        .parameters()
        .all()
        .forEach((name, value) -> present.put(name, value.text()));
    return present;
  }
}
