package org.dfra.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.dfra.app.CommandLineRobot.PATIENCE;
import static org.dfra.app.CommandLineRobot.TEAM;
import static org.dfra.app.CommandLineRobot.module;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import org.dfra.app.MarkedProcesses.Outcome;
import org.dfra.core.host.FreePorts;
import org.dfra.directory.ModuleQuery;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.io.TempDir;

/**
 * {@code ./dfra up}, {@code down}, {@code status} and {@code module}, run as a user runs them. What
 * starts processes is a process itself, and one command of each verb; the others are run in the
 * test's own virtual machine. The tests share robot t1 as long as it is as it was brought up; their
 * order only saves bringing it up again.
 */
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class RobotVerbsIT {

  /** Why a module is not ready whose device does not answer. */
  private static final Pattern NO_LINK =
      Pattern.compile(
          "t1/gps is initializing: tcp://127\\.0\\.0\\.1:\\d+: no connection within 2 s"
              + " \\(Connection refused\\)");

  @TempDir static Path folder;

  /** Every robot of these tests, whose processes end with them. */
  private static final List<CommandLineRobot> ROBOTS = new ArrayList<>();

  /** A robot t1 that is up and unchanged; null where there is none. */
  private static @Nullable CommandLineRobot shared;

  @AfterAll
  static void endWhatIsLeft() {
    for (CommandLineRobot each : ROBOTS) { // all of them, before one is waited for
      each.processes().living().forEach(ProcessHandle::destroyForcibly);
    }
    ROBOTS.forEach(each -> each.processes().close());
  }

  private static CommandLineRobot create() throws IOException {
    return kept(CommandLineRobot.create(folder));
  }

  private static CommandLineRobot create(int registrar, String described) throws IOException {
    return kept(CommandLineRobot.create(folder, registrar, described));
  }

  private static CommandLineRobot kept(CommandLineRobot robot) {
    ROBOTS.add(robot);
    return robot;
  }

  private static CommandLineRobot shared() throws Exception {
    CommandLineRobot robot = shared;
    if (robot == null) {
      robot = create();
      String unused = well(robot.up());
      shared = robot;
    }
    return robot;
  }

  @Test
  @Order(1) // it leaves its robot to the others
  void bringsARobotUpOnceAndTakesItDown() throws Exception {
    CommandLineRobot robot = create();
    Outcome up = robot.up();
    assertThat(up.exit()).as(up.out() + up.err()).isZero();
    assertThat(up.err()).isEmpty();
    assertThat(up.out())
        .contains("Started phoenix: process ", "Up: t1/registrar in group one.")
        .contains("Up: t1/warmth in group one.");
    assertThat(robot.processes().living()).as("phoenix and one group").hasSize(2);

    assertThat(robot.folder().resolve("state/phoenix.address"))
        .as("phoenix is where the robot's proxies can be reached, not where it likes")
        .hasContent("127.0.0.1:" + robot.port());

    String locator = "jini://127.0.0.1:" + robot.registrar();
    try (JiniModuleDirectory finder =
        new JiniModuleDirectory("127.0.0.1", List.of(), List.of(locator))) {
      Thermometer found =
          finder.findFirst(ModuleQuery.of(Thermometer.class), PATIENCE).orElseThrow().module();
      assertThat(found.celsius()).isEqualTo(17);
    }

    Outcome again = robot.up();
    assertThat(again.exit()).as(again.out() + again.err()).isZero();
    assertThat(again.out())
        .startsWith("Phoenix answers on port ")
        .contains("Kept: t1/warmth in group one; nothing of it has changed.");
    Outcome status = robot.inTerminalWithoutColours("status");
    assertThat(status.exit()).as(status.err()).isZero();
    assertThat(status.out())
        .as("one launch, though it was brought up twice")
        .containsPattern("t1\\.one +active +\\d+ +1 +0 +registrar, warmth");
    assertThat(robot.processes().living()).hasSize(2);

    Outcome down = robot.process("down");
    assertThat(down.exit()).as(down.out() + down.err()).isZero();
    assertThat(down.out()).isEqualToIgnoringNewLines("Phoenix and its groups have ended.");
    robot.awaitEnd();

    Outcome nothing = robot.here("down");
    assertThat(nothing.exit()).isZero();
    assertThat(nothing.out()).startsWith("No phoenix answers on port ");

    Outcome none = robot.here("status");
    assertThat(none.exit()).isEqualTo(4);
    assertThat(none.err()).startsWith("dfra: no phoenix answers on port ");

    String unused = well(robot.up());
    JsonNode history =
        new ObjectMapper()
            .readTree(well(robot.here("module", "call", "t1/warmth", "history", TEAM, "--json")));
    assertThat(history.get("activations").asInt()).isEqualTo(2);
    assertThat(history.get("failures").asInt()).as("that it was taken down is none").isZero();
    if (shared == null) {
      shared = robot;
    }
  }

  @Test
  @Order(3) // it changes the robot, and takes it down
  void modulesAreAskedAndChangedByName() throws Exception {
    CommandLineRobot robot = shared();
    shared = null;
    CompletableFuture<String> listedInVain =
        beside(() -> well(robot.here("module", "list", TEAM, "--kind=GPSSensor", "--wait=8")));
    CompletableFuture<Void> askedInVain =
        beside(
            () ->
                fails(
                    3,
                    "there is no module t1/warmt; did you mean \"t1/warmth\"?",
                    robot.here("module", "call", "t1/warmt", "celsius", TEAM, "--wait=5")));
    CompletableFuture<Void> nowhere =
        beside(
            () -> {
              String state = "--state=" + robot.folder().resolve("nowhere");
              fails(
                  3,
                  "no lookup service answers",
                  MarkedProcesses.here("module", "list", TEAM, "--wait=2", state));
            });

    assertThat(well(robot.here("module", "list", TEAM)))
        .containsPattern("MODULE +KIND +STATE +CLIENTS +HOST +LAST SEEN")
        .containsPattern("t1/warmth +Thermometer +ready +0 +127\\.0\\.0\\.1 +now");
    JsonNode listed =
        new ObjectMapper().readTree(well(robot.here("module", "list", TEAM, "--json")));
    assertThat(listed).hasSize(1);
    assertThat(listed.get(0).get("kinds").get(0).asText()).isEqualTo("Thermometer");

    assertThat(well(robot.here("module", "call", "warmth", "celsius", TEAM)))
        .isEqualToIgnoringNewLines("17");
    assertThat(well(robot.here("module", "call", "t1/warmth", TEAM)))
        .containsPattern("celsius\\(\\) +double +yes");
    assertThat(well(robot.here("module", "info", "t1/warmth", TEAM)))
        .contains("module: t1/warmth", "kinds: Thermometer", "state: READY");
    fails(
        3,
        "the module has no method celsiu; did you mean \"celsius\"?",
        robot.here("module", "call", "warmth", "celsiu", TEAM));
    fails(
        2,
        "there is no celsius with 1 arguments; there is celsius()",
        robot.here("module", "call", "warmth", "celsius", "3", TEAM));
    assertThat(listedInVain.get())
        .isEqualToIgnoringNewLines("No module of kind GPSSensor is registered.");
    CompletableFuture.allOf(askedInVain, nowhere).get();

    stopAndKill(robot);
    change(robot);

    assertThat(well(robot.here("down", "t1"))).isEqualToIgnoringNewLines("t1 is down.");
    assertThat(well(robot.here("status"))).startsWith("Phoenix answers, but no such robot is up");
    fails(3, "robot t1 is not up on this host; none is", robot.here("down", "t1"));
    String unused = well(robot.here("down"));
    robot.awaitEnd();
  }

  private static void stopAndKill(CommandLineRobot robot) throws Exception {
    String unused = well(robot.here("module", "stop", "warmth", TEAM));
    assertThat(well(robot.here("module", "list", TEAM, "--wait=8")))
        .startsWith("No module is registered.");
    unused = well(robot.here("module", "start", "t1/warmth"));
    assertThat(well(robot.here("module", "call", "warmth", "celsius", TEAM))).startsWith("17");

    assertThat(well(robot.here("module", "kill", "t1/warmth")))
        .startsWith("Killed group one of t1");
    fails(
        3,
        "this host has no module t1/warmt; did you mean \"t1/warmth\"?",
        robot.here("module", "kill", "t1/warmt"));
    assertThat(well(robot.here("module", "call", "t1/warmth", "celsius", TEAM)))
        .as("phoenix has brought it back")
        .startsWith("17");
  }

  private static void change(CommandLineRobot robot) throws Exception {
    Path xml = robot.xml();
    Files.writeString(
        xml,
        Files.readString(xml)
            .replace("value=\"17\"", "value=\"18\"")
            .replace("</group>", module("chill", -3) + "</group>"));
    String unused = well(robot.process("module", "add", xml.toString(), "chill"));
    unused = well(robot.process("module", "replace", xml.toString(), "warmth"));
    assertThat(well(robot.here("module", "call", "t1/chill", "celsius", TEAM))).startsWith("-3");
    assertThat(well(robot.here("module", "call", "t1/warmth", "celsius", TEAM))).startsWith("18");
    fails(
        1,
        "robot t1 has no module chil; did you mean \"chill\"?",
        robot.here("module", "add", xml.toString(), "chil"));
    unused = well(robot.here("module", "remove", "t1/chill"));
    assertThat(well(robot.here("status"))).doesNotContain("chill");

    Files.writeString(xml, Files.readString(xml).replace("value=\"18\"", "value=\"19\""));
    assertThat(well(robot.process("up", xml.toString())))
        .contains(
            "Kept: t1/registrar in group one; nothing of it has changed.",
            "Restarted: t1/warmth in group one; changed: parameter celsius.",
            "Up: t1/chill in group one.");
    unused = well(robot.here("module", "stop", "chill", TEAM));
    assertThat(well(robot.here("status"))).contains("registrar, warmth, chill (not running)");
  }

  @Test
  @Order(2)
  void twoRobotsOfOneNameAreDistinguishedByTheirHosts() throws Exception {
    CommandLineRobot robot = shared();
    CommandLineRobot namesake =
        create(
            robot.registrar(),
            """
            <robot xmlns="urn:dfra:robot:1" name="t1" host="127.0.0.2">
              <lookup locators="127.0.0.1:%d"/>
              <group name="one">
                %s
                <module name="gps" properties="%s">
                  <parameter name="link" value="tcp://127.0.0.1:%d"/>
                </module>
              </group>
            </robot>
            """
                .formatted(
                    robot.registrar(),
                    module("warmth", 23),
                    Path.of(System.getProperty("dfra.root"), "config/modules/m12plus.properties"),
                    FreePorts.allocate())); // where nobody answers
    Outcome up = namesake.up();
    assertThat(up.exit()).as("it comes up all the same: " + up.err()).isZero();
    assertThat(up.err())
        .contains("ANOTHER ROBOT IS NAMED t1, on 127.0.0.1, and this one on 127.0.0.2; ");

    Outcome list =
        await()
            .atMost(PATIENCE) // its driver may be about to try its link first
            .until(
                () -> robot.here("module", "list", TEAM),
                each -> NO_LINK.matcher(each.out()).find());
    assertThat(list.out())
        .contains("127.0.0.1", "127.0.0.2")
        .containsPattern("t1/gps +GPSSensor +initializing ");
    assertThat(list.err()).contains("2 robots are named t1, on 127.0.0.1 and 127.0.0.2; ");
    fails(
        3,
        "there are several modules t1/warmth; name one of t1@127.0.0.1/warmth,"
            + " t1@127.0.0.2/warmth",
        robot.here("module", "call", "t1/warmth", "celsius", TEAM));
    assertThat(well(robot.here("module", "call", "t1@127.0.0.2/warmth", "celsius", TEAM)))
        .startsWith("23");
    Outcome doctor = robot.here("doctor", TEAM);
    assertThat(doctor.out())
        .contains("2 robots are named t1, on 127.0.0.1 and 127.0.0.2")
        .containsPattern("WARN +module +" + NO_LINK.pattern());
    assertThat(doctor.exit()).isEqualTo(1);
    String unused = well(namesake.here("down"));
    namesake.awaitEnd();
  }

  @Test
  void theTimeToWaitIsReadFromTheEnvironment() throws Exception {
    CommandLineRobot robot = create();
    String locator = "--locator=127.0.0.1:" + robot.registrar();
    robot.processes().set("DFRA_WAIT", "soon");
    fails(
        2,
        "DFRA_WAIT=soon is not a number of seconds from 0 to 3600",
        robot.process("module", "list", TEAM, locator));
    fails(
        3,
        "no lookup service answers",
        robot.process("module", "list", TEAM, locator, "--wait=0.1"));
    robot.processes().set("DFRA_WAIT", "0.1");
    fails(3, "no lookup service answers", robot.process("module", "list", TEAM, locator));
  }

  private static String well(Outcome outcome) {
    assertThat(outcome.exit()).as(outcome.out() + outcome.err()).isZero();
    return outcome.out();
  }

  private static void fails(int code, String sentence, Outcome outcome) {
    assertThat(outcome.err()).startsWith("dfra: ").contains(sentence).hasLineCount(1);
    assertThat(outcome.exit()).isEqualTo(code);
  }

  /** Runs a command that waits for what does not come, while the test goes on. */
  private static <T> CompletableFuture<T> beside(Supplier<T> command) {
    return CompletableFuture.supplyAsync(command);
  }

  private static CompletableFuture<Void> beside(Runnable command) {
    return CompletableFuture.runAsync(command);
  }
}
