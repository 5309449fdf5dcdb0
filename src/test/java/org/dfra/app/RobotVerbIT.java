package org.dfra.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import org.dfra.app.MarkedProcesses.Outcome;
import org.dfra.directory.ModuleQuery;
import org.dfra.example.thermometer.SteadyThermometerImpl;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code ./dfra robot}, run as a user runs it. */
class RobotVerbIT {

  private static final Duration PATIENCE = Duration.ofSeconds(40);

  @TempDir Path folder;

  @Test
  void bringsARobotUpOnceAndTakesItDown() throws Exception {
    int registrar = freePort();
    String port = "--port=" + freePort();
    String registry = "--registry-port=-1";
    String state = "--state=" + folder.resolve("state");
    String xml = robot(registrar).toString();
    try (MarkedProcesses processes = new MarkedProcesses(folder)) {
      Outcome up = processes.dfra(PATIENCE, "robot", xml, port, registry, state);
      assertThat(up.exit()).as(up.out() + up.err()).isZero();
      assertThat(up.err()).isEmpty();
      assertThat(up.out())
          .contains("Started phoenix: process ", "Up: t1/registrar in group one.")
          .contains("Up: t1/warmth in group one.", "Group 1-t1.one: process ");
      assertThat(processes.living()).as("phoenix and one group").hasSize(2);

      assertThat(folder.resolve("state/phoenix.host"))
          .as("phoenix is where the robot's proxies can be reached, not where it likes")
          .hasContent("127.0.0.1");

      String locator = "jini://127.0.0.1:" + registrar;
      try (JiniModuleDirectory finder =
          new JiniModuleDirectory("127.0.0.1", java.util.List.of(), java.util.List.of(locator))) {
        Thermometer found =
            finder.findFirst(ModuleQuery.of(Thermometer.class), PATIENCE).orElseThrow().module();
        assertThat(found.celsius()).isEqualTo(17);
      }

      Outcome again = processes.dfra(PATIENCE, "robot", xml, port, registry, state);
      assertThat(again.exit()).as(again.out() + again.err()).isZero();
      assertThat(again.out()).startsWith("Phoenix answers on port ");
      assertThat(lastLine(again)).as("the same process").isEqualTo(lastLine(up));
      assertThat(processes.living()).hasSize(2);

      Outcome down = processes.dfra(PATIENCE, "robot", "--down", port, registry, state);
      assertThat(down.exit()).as(down.out() + down.err()).isZero();
      assertThat(down.out()).isEqualToIgnoringNewLines("Phoenix and its groups have ended.");
      org.awaitility.Awaitility.await()
          .atMost(PATIENCE)
          .untilAsserted(() -> assertThat(processes.living()).isEmpty());

      Outcome nothing = processes.dfra(PATIENCE, "robot", "--down", port, registry, state);
      assertThat(nothing.exit()).isZero();
      assertThat(nothing.out()).startsWith("No phoenix answers on port ");
    }
  }

  private static String lastLine(Outcome outcome) {
    return outcome.out().lines().reduce((a, b) -> b).orElse("");
  }

  private Path robot(int registrar) throws IOException {
    return Files.writeString(
        folder.resolve("t1.xml"),
        """
        <robot xmlns="urn:dfra:robot:1" name="t1" host="127.0.0.1">
          <group name="one">
            <registrar port="%d"/>
            <module name="warmth" server="%s" proxy="%s" driver="%s">
              <parameter name="celsius" value="17"/>
            </module>
          </group>
        </robot>
        """
            .formatted(
                registrar,
                ThermometerServer.class.getName(),
                ThermometerProxy.class.getName(),
                SteadyThermometerImpl.class.getName()));
  }

  private static int freePort() throws IOException {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"))) {
      return socket.getLocalPort();
    }
  }
}
