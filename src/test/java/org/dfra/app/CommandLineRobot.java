package org.dfra.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.dfra.app.MarkedProcesses.Outcome;
import org.dfra.core.host.FreePorts;
import org.dfra.example.thermometer.SteadyThermometerImpl;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;

/**
 * Robot t1, which commands bring up and take down, with a phoenix of its own in a folder of its
 * own.
 *
 * @param registrar port of its registrar, or of the one that it joins
 * @param port of its phoenix
 */
record CommandLineRobot(MarkedProcesses processes, Path folder, Path xml, int registrar, int port) {

  static final Duration PATIENCE = Duration.ofSeconds(240);

  /** No discovery group: what is found is found by locators. */
  static final String TEAM = "--team=";

  /** Describes one with a registrar and one thermometer; it is not up yet. */
  static CommandLineRobot create(Path folder) throws IOException {
    int registrar = FreePorts.allocate();
    return create(
        folder,
        registrar,
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

  /** The same with another description. */
  static CommandLineRobot create(Path folder, int registrar, String described) throws IOException {
    Path own = Files.createTempDirectory(folder, "robot");
    Path xml = Files.writeString(own.resolve("t1.xml"), described);
    return new CommandLineRobot(
        new MarkedProcesses(own), own, xml, registrar, FreePorts.allocate());
  }

  Outcome up() throws Exception {
    return process("up", xml.toString(), "--port=" + port, "--registry-port=-1");
  }

  /** Runs a command as a user does. */
  Outcome process(String... arguments) throws Exception {
    return plain(processes.dfra(PATIENCE, with(state(), arguments)));
  }

  /** As a process in a terminal of which somebody wants no colours. */
  Outcome inTerminalWithoutColours(String... arguments) throws Exception {
    MarkedProcesses terminal = new MarkedProcesses(folder, "-Dpicocli.ansi=true");
    terminal.set("NO_COLOR", "1");
    return plain(terminal.dfra(PATIENCE, with(state(), arguments)));
  }

  /** Nothing here is a terminal with colours. */
  private static Outcome plain(Outcome outcome) {
    assertThat(outcome.out() + outcome.err())
        .as("control characters")
        .doesNotContainPattern("[\\p{Cntrl}&&[^\n]]");
    return outcome;
  }

  /** The same in the test's own process, for what starts none. */
  Outcome here(String... arguments) {
    List<String> words = List.of(arguments);
    boolean isPatient =
        words.contains(TEAM) && words.stream().noneMatch(each -> each.startsWith("--wait="));
    String[] all = with(state(), arguments);
    return plain(MarkedProcesses.here(isPatient ? with("--wait=20", all) : all));
  }

  private String state() {
    return "--state=" + folder.resolve("state");
  }

  private static String[] with(String option, String... words) {
    return Stream.concat(Arrays.stream(words), Stream.of(option)).toArray(String[]::new);
  }

  void awaitEnd() {
    await().atMost(PATIENCE).untilAsserted(() -> assertThat(processes.living()).isEmpty());
  }

  /** A module of its description: a thermometer that always reads the same. */
  static String module(String name, int celsius) {
    return """
    <module name="%s" server="%s" proxy="%s" implementation="%s">
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
}
