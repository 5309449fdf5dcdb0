package org.dfra.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.dfra.app.MarkedProcesses.Outcome;
import org.dfra.core.host.FreePorts;
import org.dfra.directory.ModuleQuery;
import org.dfra.example.thermometer.SteadyThermometerImpl;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code ./dfra up}, {@code down}, {@code status} and {@code module}, run as a user runs them. */
class RobotVerbsIT {

  private static final Duration PATIENCE = Duration.ofSeconds(240);

  @TempDir Path folder;

  @Test
  void bringsARobotUpOnceAndTakesItDown() throws Exception {
    int registrar = FreePorts.next();
    String port = "--port=" + FreePorts.next();
    String registry = "--registry-port=-1";
    String state = "--state=" + folder.resolve("state");
    String xml = robot(registrar).toString();
    try (MarkedProcesses processes = new MarkedProcesses(folder)) {
      Outcome up = processes.dfra(PATIENCE, "up", xml, port, registry, state);
      assertThat(up.exit()).as(up.out() + up.err()).isZero();
      assertThat(up.err()).isEmpty();
      assertThat(up.out())
          .contains("Started phoenix: process ", "Up: t1/registrar in group one.")
          .contains("Up: t1/warmth in group one.");
      assertThat(processes.living()).as("phoenix and one group").hasSize(2);

      assertThat(folder.resolve("state/phoenix.address"))
          .as("phoenix is where the robot's proxies can be reached, not where it likes")
          .hasContent("127.0.0.1:" + port.replace("--port=", ""));

      String locator = "jini://127.0.0.1:" + registrar;
      try (JiniModuleDirectory finder =
          new JiniModuleDirectory("127.0.0.1", List.of(), List.of(locator))) {
        Thermometer found =
            finder.findFirst(ModuleQuery.of(Thermometer.class), PATIENCE).orElseThrow().module();
        assertThat(found.celsius()).isEqualTo(17);
      }

      Outcome again = processes.dfra(PATIENCE, "up", xml, port, registry, state);
      assertThat(again.exit()).as(again.out() + again.err()).isZero();
      assertThat(again.out())
          .startsWith("Phoenix answers on port ")
          .contains("Kept: t1/warmth in group one; nothing of it has changed.");
      Outcome status = processes.dfra(PATIENCE, "status", state);
      assertThat(status.out())
          .as("one launch, though it was brought up twice")
          .containsPattern("t1\\.one +active +\\d+ +1 +0 +registrar, warmth");
      assertThat(processes.living()).hasSize(2);

      Outcome down = processes.dfra(PATIENCE, "down", state);
      assertThat(down.exit()).as(down.out() + down.err()).isZero();
      assertThat(down.out()).isEqualToIgnoringNewLines("Phoenix and its groups have ended.");
      await().atMost(PATIENCE).untilAsserted(() -> assertThat(processes.living()).isEmpty());

      Outcome nothing = processes.dfra(PATIENCE, "down", state);
      assertThat(nothing.exit()).isZero();
      assertThat(nothing.out()).startsWith("No phoenix answers on port ");

      Outcome none = processes.dfra(PATIENCE, "status", state);
      assertThat(none.exit()).isEqualTo(4);
      assertThat(none.err()).startsWith("dfra: no phoenix answers on port ");

      Verbs verbs = new Verbs(processes, state, true);
      verbs.well("up", xml, port, registry);
      JsonNode history =
          new ObjectMapper()
              .readTree(verbs.well("module", "call", "t1/warmth", "history", "--team=", "--json"));
      assertThat(history.get("activations").asInt()).isEqualTo(2);
      assertThat(history.get("failures").asInt()).as("that it was taken down is none").isZero();
      verbs.well("down");
      await().atMost(PATIENCE).untilAsserted(() -> assertThat(processes.living()).isEmpty());
    }
  }

  @Test
  void modulesAreAskedAndChangedByName() throws Exception {
    int registrar = FreePorts.next();
    String state = "--state=" + folder.resolve("state");
    Path xml = robot(registrar);
    try (MarkedProcesses processes = new MarkedProcesses(folder)) {
      Verbs verbs = new Verbs(processes, state, true);
      verbs.well("up", xml.toString(), "--port=" + FreePorts.next(), "--registry-port=-1");

      assertThat(verbs.well("module", "list", "--team="))
          .containsPattern("MODULE +KIND +STATE +CLIENTS +HOST +SEEN")
          .containsPattern("t1/warmth +Thermometer +ready +0 +127\\.0\\.0\\.1 +now");
      JsonNode listed =
          new ObjectMapper().readTree(verbs.well("module", "list", "--team=", "--json"));
      assertThat(listed).hasSize(1);
      assertThat(listed.get(0).get("kinds").get(0).asText()).isEqualTo("Thermometer");
      assertThat(verbs.well("module", "list", "--team=", "--kind=GPSSensor", "--wait=8"))
          .isEqualToIgnoringNewLines("No module of kind GPSSensor is registered.");

      assertThat(verbs.well("module", "call", "warmth", "celsius", "--team="))
          .isEqualToIgnoringNewLines("17");
      assertThat(verbs.well("module", "call", "t1/warmth", "--team="))
          .containsPattern("celsius\\(\\) +double +yes");
      assertThat(verbs.well("module", "info", "t1/warmth", "--team="))
          .contains("module: t1/warmth", "kinds: Thermometer", "state: READY");
      verbs.fails(
          3,
          "there is no module t1/warmt; did you mean \"t1/warmth\"?",
          "module",
          "call",
          "t1/warmt",
          "celsius",
          "--team=",
          "--wait=5");
      verbs.fails(
          3,
          "the module has no method celsiu; did you mean \"celsius\"?",
          "module",
          "call",
          "warmth",
          "celsiu",
          "--team=");
      verbs.fails(
          2,
          "there is no celsius with 1 arguments; there is celsius()",
          "module",
          "call",
          "warmth",
          "celsius",
          "3",
          "--team=");
      verbs.fails(
          3,
          "no lookup service answers",
          "module",
          "list",
          "--team=",
          "--wait=2",
          "--state=" + folder.resolve("nowhere"));

      verbs.well("module", "stop", "warmth", "--team=");
      assertThat(verbs.well("module", "list", "--team=", "--wait=8"))
          .startsWith("No module is registered.");
      verbs.well("module", "start", "t1/warmth");
      assertThat(verbs.well("module", "call", "warmth", "celsius", "--team=")).startsWith("17");

      assertThat(verbs.well("module", "kill", "t1/warmth")).startsWith("Killed group one of t1");
      verbs.fails(
          3,
          "this host has no module t1/warmt; did you mean \"t1/warmth\"?",
          "module",
          "kill",
          "t1/warmt");
      assertThat(verbs.well("module", "call", "t1/warmth", "celsius", "--team="))
          .as("phoenix has brought it back")
          .startsWith("17");

      Files.writeString(
          xml,
          Files.readString(xml)
              .replace("value=\"17\"", "value=\"18\"")
              .replace("</group>", module("chill", -3) + "</group>"));
      verbs.well("module", "add", xml.toString(), "chill");
      verbs.well("module", "replace", xml.toString(), "warmth");
      assertThat(verbs.well("module", "call", "t1/chill", "celsius", "--team=")).startsWith("-3");
      assertThat(verbs.well("module", "call", "t1/warmth", "celsius", "--team=")).startsWith("18");
      verbs.fails(
          1,
          "robot t1 has no module chil; did you mean \"chill\"?",
          "module",
          "add",
          xml.toString(),
          "chil");
      verbs.well("module", "remove", "t1/chill");
      assertThat(verbs.well("status")).doesNotContain("chill");

      Files.writeString(xml, Files.readString(xml).replace("value=\"18\"", "value=\"19\""));
      assertThat(verbs.well("up", xml.toString()))
          .contains(
              "Kept: t1/registrar in group one; nothing of it has changed.",
              "Restarted: t1/warmth in group one; changed: parameter celsius.",
              "Up: t1/chill in group one.");
      verbs.well("module", "stop", "chill", "--team=");
      assertThat(verbs.well("status")).contains("registrar, warmth, chill (not running)");

      assertThat(verbs.well("down", "t1")).isEqualToIgnoringNewLines("t1 is down.");
      assertThat(verbs.well("status")).startsWith("Phoenix answers, but no such robot is up");
      verbs.fails(3, "robot t1 is not up on this host; none is", "down", "t1");
      verbs.well("down");
      await().atMost(PATIENCE).untilAsserted(() -> assertThat(processes.living()).isEmpty());
    }
  }

  @Test
  void twoRobotsOfOneNameAreToldApartByTheirHosts() throws Exception {
    int registrar = FreePorts.next();
    Path xml = robot(registrar);
    Path namesake =
        Files.writeString(
            Files.createDirectory(folder.resolve("other")).resolve("t1.xml"),
            """
            <robot xmlns="urn:dfra:robot:1" name="t1" host="127.0.0.2">
              <lookup locators="127.0.0.1:%d"/>
              <group name="one">%s</group>
            </robot>
            """
                .formatted(registrar, module("warmth", 23)));
    try (MarkedProcesses processes = new MarkedProcesses(folder)) {
      Verbs verbs = new Verbs(processes, "--state=" + folder.resolve("state"), true);
      Verbs others = new Verbs(processes, "--state=" + folder.resolve("other/state"), true);
      verbs.well("up", xml.toString(), "--port=" + FreePorts.next(), "--registry-port=-1");
      Outcome up =
          others.run("up", namesake.toString(), "--port=" + FreePorts.next(), "--registry-port=-1");
      assertThat(up.exit()).as("it comes up all the same: " + up.err()).isZero();
      assertThat(up.err())
          .contains("ANOTHER ROBOT IS NAMED t1, on 127.0.0.1, and this one on 127.0.0.2; ");

      Outcome list = verbs.run("module", "list", "--team=");
      assertThat(list.out()).contains("127.0.0.1", "127.0.0.2");
      assertThat(list.err()).contains("2 robots are named t1, on 127.0.0.1 and 127.0.0.2; ");
      verbs.fails(
          3,
          "there are several modules t1/warmth; name one of t1@127.0.0.1/warmth,"
              + " t1@127.0.0.2/warmth",
          "module",
          "call",
          "t1/warmth",
          "celsius",
          "--team=");
      assertThat(verbs.well("module", "call", "t1@127.0.0.2/warmth", "celsius", "--team="))
          .startsWith("23");
      Outcome doctor = verbs.run("doctor", "--team=");
      assertThat(doctor.out()).contains("2 robots are named t1, on 127.0.0.1 and 127.0.0.2");
      assertThat(doctor.exit()).isEqualTo(1);
      others.well("down");
      verbs.well("down");
      await().atMost(PATIENCE).untilAsserted(() -> assertThat(processes.living()).isEmpty());
    }
  }

  @Test
  void theTimeToWaitIsReadFromTheEnvironment() throws Exception {
    try (MarkedProcesses processes = new MarkedProcesses(folder)) {
      String locator = "--locator=127.0.0.1:" + FreePorts.next();
      Verbs verbs = new Verbs(processes, "--state=" + folder.resolve("state"), false);
      processes.set("DFRA_WAIT", "soon");
      verbs.fails(
          2,
          "DFRA_WAIT=soon is not a number of seconds from 0 to 3600",
          "module",
          "list",
          "--team=",
          locator);
      verbs.fails(
          3, "no lookup service answers", "module", "list", "--team=", locator, "--wait=0.1");
      processes.set("DFRA_WAIT", "0.1");
      verbs.fails(3, "no lookup service answers", "module", "list", "--team=", locator);
    }
  }

  /**
   * Runs commands on one state folder.
   *
   * @param inThisProcess whether what looks for robots, and starts nothing, is run here
   */
  private record Verbs(MarkedProcesses processes, String state, boolean inThisProcess) {

    String well(String... arguments) throws Exception {
      Outcome outcome = run(arguments);
      assertThat(outcome.exit()).as(outcome.out() + outcome.err()).isZero();
      return outcome.out();
    }

    void fails(int code, String sentence, String... arguments) throws Exception {
      Outcome outcome = run(arguments);
      assertThat(outcome.err()).startsWith("dfra: ").contains(sentence).hasLineCount(1);
      assertThat(outcome.exit()).isEqualTo(code);
    }

    private Outcome run(String... arguments) throws Exception {
      boolean hasState = Arrays.stream(arguments).anyMatch(each -> each.startsWith("--state="));
      String[] all =
          hasState
              ? arguments
              : Stream.concat(Arrays.stream(arguments), Stream.of(state)).toArray(String[]::new);
      if (!inThisProcess || !List.of(arguments).contains("--team=")) {
        return processes.dfra(PATIENCE, all);
      }
      boolean hasWait = Arrays.stream(arguments).anyMatch(each -> each.startsWith("--wait="));
      return MarkedProcesses.here(
          Stream.concat(Arrays.stream(all), Stream.of("--wait=20").filter(each -> !hasWait))
              .toArray(String[]::new));
    }
  }

  private static String module(String name, int celsius) {
    return """
    <module name="%s" server="%s" proxy="%s" driver="%s">
      <parameter name="celsius" value="%d"/>
    </module>
    """
        .formatted(
            name,
            ThermometerServer.class.getName(),
            ThermometerProxy.class.getName(),
            SteadyThermometerImpl.class.getName(),
            celsius);
  }

  private Path robot(int registrar) throws IOException {
    return Files.writeString(
        folder.resolve("t1.xml"),
        """
        <robot xmlns="urn:dfra:robot:1" name="t1" host="127.0.0.1">
          <group name="one">
            <registrar port="%d"/>
            %s
          </group>
        </robot>
        """
            .formatted(registrar, module("warmth", 17)));
  }
}
