package org.dfra.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;
import org.dfra.app.MarkedProcesses.Outcome;
import org.dfra.core.host.FreePorts;
import org.dfra.core.host.PrivateFiles;
import org.dfra.example.thermometer.SteadyThermometerImpl;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code ./dfra doctor} on a robot that runs, and after its registrar was stopped. */
class DoctorIT {

  private static final Duration PATIENCE = Duration.ofSeconds(40);

  @TempDir Path folder;

  @Test
  void findsARobotWellAndThenIll() throws Exception {
    int registrar = FreePorts.allocate();
    String state = "--state=" + folder.resolve("state");
    // Not the usual port, where somebody else's phoenix may answer.
    PrivateFiles.requireFolder(folder.resolve("state"));
    Path address = folder.resolve("state/phoenix.address");
    Files.writeString(address, "127.0.0.1:" + FreePorts.allocate());
    try (MarkedProcesses processes = new MarkedProcesses(folder)) {
      Outcome none = doctor(state, 2); // for nobody
      assertThat(found(none, "phoenix")).containsExactly("warn");
      assertThat(found(none, "registrar")).containsExactly("warn");
      assertThat(none.exit()).as("no robot is no failure: " + none.out()).isZero();

      Outcome up =
          processes.dfra(
              PATIENCE,
              "up",
              robot(registrar).toString(),
              "--port=" + FreePorts.allocate(),
              "--registry-port=-1",
              state);
      assertThat(up.exit()).as(up.out() + up.err()).isZero();
      // A computer that stands still gives no answer in time, and that is found too.
      Outcome well =
          await()
              .atMost(PATIENCE.multipliedBy(3))
              .until(
                  () -> {
                    Outcome outcome = doctor(state, 20);
                    return found(outcome, "clock").contains("ok") ? outcome : null;
                  },
                  Objects::nonNull);
      assertThat(found(well, "java")).containsExactly("ok");
      assertThat(found(well, "boot-jar")).containsExactly("ok");
      assertThat(found(well, "state-folder")).containsExactly("ok");
      assertThat(found(well, "journal")).containsExactly("ok");
      assertThat(found(well, "phoenix")).containsExactly("ok");
      assertThat(found(well, "group")).containsExactly("ok", "ok");
      assertThat(found(well, "registrar")).hasSize(1).doesNotContain("fail");
      assertThat(found(well, "clock")).containsExactly("ok");
      assertThat(well.exit()).as(well.out()).isZero();
      String pid = Files.readString(folder.resolve("state/phoenix.pid")).strip();
      assertThat(well.out()).contains("process " + pid + " answers at 127.0.0.1:");

      long lookup = pidOf(well, "group r1.lookup is process ");
      signal(lookup, "STOP");
      try {
        CompletableFuture<Outcome> beside =
            CompletableFuture.supplyAsync(() -> doctor(state, 10)); // it is all used up, each time
        processes.set("DFRA_WAIT", "10");
        Outcome reported = processes.dfra(PATIENCE, "doctor", "--team=", state);
        assertThat(reported.out())
            .contains("FAIL  registrar", "→ ")
            .doesNotContain("\u001b")
            .containsPattern("\n1 failure, \\d+ warnings?\\.\n$|\n1 failure\\.\n$");
        assertThat(reported.exit()).as(reported.out()).isEqualTo(1);
        Outcome ill = beside.get();
        assertThat(found(ill, "registrar")).containsExactly("fail");
        assertThat(ill.exit()).as(ill.out()).isEqualTo(1);
      } finally {
        signal(lookup, "CONT");
      }
      assertThat(MarkedProcesses.here("down", state).exit()).isZero();
    }
  }

  private static String[] asked(String state) {
    return new String[] {"doctor", "--json", "--team=", "--host=127.0.0.1", state};
  }

  /** Asks in the test's own virtual machine. */
  private static Outcome doctor(String state, int wait) {
    Outcome outcome =
        MarkedProcesses.here(
            Stream.concat(Arrays.stream(asked(state)), Stream.of("--wait=" + wait))
                .toArray(String[]::new));
    assertThat(outcome.err()).isEmpty();
    return outcome;
  }

  /** The verdicts on a subject. */
  private static List<String> found(Outcome outcome, String subject) throws IOException {
    List<String> verdicts = new ArrayList<>();
    JsonNode report = new ObjectMapper().readTree(outcome.out());
    for (JsonNode each : report.get("findings")) {
      if (each.get("subject").asText().equals(subject)) {
        verdicts.add(each.get("verdict").asText());
      }
    }
    return verdicts;
  }

  private static long pidOf(Outcome outcome, String what) {
    int at = outcome.out().indexOf(what) + what.length();
    return Long.parseLong(outcome.out().substring(at, outcome.out().indexOf('"', at)));
  }

  private static void signal(long pid, String name) throws Exception {
    assertThat(new ProcessBuilder("kill", "-" + name, Long.toString(pid)).start().waitFor())
        .isZero();
  }

  private Path robot(int registrar) throws IOException {
    return Files.writeString(
        folder.resolve("r1.xml"),
        """
        <robot xmlns="urn:dfra:robot:1" name="r1" host="127.0.0.1">
          <group name="lookup">
            <registrar port="%d"/>
          </group>
          <group name="one">
            <module name="warmth" server="%s" proxy="%s" implementation="%s">
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
}
