package org.dfra.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;
import org.dfra.app.MarkedProcesses.Outcome;
import org.dfra.core.host.FreePorts;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.device.gps.M12Emulator;
import org.dfra.sim.device.gps.M12EmulatorSettings;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** {@code ./dfra persona}, {@code event}, {@code lease} and {@code log} with a robot that runs. */
@Timeout(240)
class TalkVerbsIT {

  private static final Duration PATIENCE = Duration.ofSeconds(60);
  private static final String GPS = "zeta/gps_front";

  @TempDir static Path folder;

  private static M12Emulator receiver;
  private static MarkedProcesses processes;

  /** Runs what goes on while something else is asked. */
  private static MarkedProcesses beside;

  @BeforeAll
  static void bringUp() throws Exception {
    receiver =
        new M12Emulator(
            M12EmulatorSettings.at(new GeoPosition(27.98, -82.45, 14)).withBaud(115_200),
            Instant::now);
    receiver.start();
    processes = new MarkedProcesses(folder);
    beside = new MarkedProcesses(Files.createDirectory(folder.resolve("beside")));
    Path xml = folder.resolve("robot.xml");
    Files.writeString(
        xml,
        """
        <robot xmlns="urn:dfra:robot:1" name="zeta" host="127.0.0.1">
          <persona role="scout"><goal>Map the field.</goal></persona>
          <group name="lookup"><registrar port="%d"/></group>
          <group name="gps">
            <module name="gps_front" server="org.dfra.river.server.sensor.GPSServer"
                proxy="org.dfra.river.proxy.sensor.GPSProxy"
                implementation="org.dfra.drivers.gps.m12.M12PlusImpl">
              <parameter name="link" value="%s"/>
            </module>
          </group>
        </robot>
        """
            .formatted(FreePorts.allocate(), receiver.url()));
    Outcome up =
        processes.dfra(
            PATIENCE,
            "up",
            xml.toString(),
            "--port=" + FreePorts.allocate(),
            "--registry-port=-1",
            state());
    assertThat(up.exit()).as(up.out() + up.err()).isZero();
    await().atMost(PATIENCE).until(() -> !output("module", "list").contains("initializing"));
  }

  @AfterAll
  static void takeDown() throws Exception {
    try {
      Outcome down = MarkedProcesses.here("down", state());
      assertThat(down.exit()).as(down.out() + down.err()).isZero();
    } finally {
      beside.close();
      processes.close();
      receiver.close();
    }
  }

  private static String state() {
    return "--state=" + folder.resolve("state");
  }

  private static String[] asked(String... words) {
    return Stream.concat(Arrays.stream(words), Stream.of("--team=", "--host=127.0.0.1", state()))
        .toArray(String[]::new);
  }

  /** Where something is missing the time to wait is used up. */
  private static Outcome ask(String... words) {
    boolean hasWait = Arrays.stream(words).anyMatch(each -> each.startsWith("--wait="));
    return MarkedProcesses.here(
        Stream.concat(Arrays.stream(asked(words)), Stream.of("--wait=20").filter(each -> !hasWait))
            .toArray(String[]::new));
  }

  private static String output(String... words) {
    Outcome outcome = ask(words);
    assertThat(outcome.exit()).as(outcome.out() + outcome.err()).isZero();
    return outcome.out();
  }

  private CompletableFuture<Outcome> askBeside(String... words) {
    return CompletableFuture.supplyAsync(
        () -> {
          try {
            return beside.dfra(PATIENCE, asked(words));
          } catch (IOException | InterruptedException e) {
            throw new IllegalStateException(e);
          }
        },
        task -> new Thread(task, "beside").start());
  }

  @Test
  void robotsAreShownAndFoundByWhatTheyCanDo() throws Exception {
    assertThat(output("persona", "list").lines().map(line -> line.replaceAll(" +", " ")))
        .containsExactly("ROBOT ROLE MODULES HOST LAST SEEN", "zeta scout 1 127.0.0.1 now");
    assertThat(output("persona", "show", "zeta"))
        .contains("zeta, scout", "seen now", "Goals", "  Map the field.")
        .contains("gps_front, GPSSensor: ", "gps receiver: ", "fix modes 2D 3D", "sensor: reads");
    assertThat(output("persona", "show", "zeta", "--json"))
        .contains("\"role\" : \"scout\"", "\"fixModes\" : [ \"2D\", \"3D\" ]");

    assertThat(
            output(
                "persona",
                "find",
                "LocationSensor with sensor.maxRate >= 1 and gps_receiver.fixModes contains \"3D\""
                    + " on zeta within 50 m of 27.98, -82.45"))
        .contains(GPS);
    Outcome none = ask("persona", "find", "GPSSensor within 50 m of 27.99, -82.45", "--wait=6");
    assertThat(none.exit()).isEqualTo(3);
    assertThat(none.out().strip())
        .isEqualTo("There is no GPSSensor within 50.0 m of 27.99°, -82.45°.");
    Outcome wrong = ask("persona", "find", "GPSSensor with sensor.maxRat >= 1");
    assertThat(wrong.exit()).isEqualTo(2);
    assertThat(wrong.err().strip())
        .isEqualTo(
            "dfra: in the query, at character 16: SensorAttributes has no component \"maxRat\"; did"
                + " you mean \"maxRate\"?");
    Outcome nobody = ask("persona", "show", "zetta", "--wait=6");
    assertThat(nobody.exit()).isEqualTo(3);
    assertThat(nobody.err().strip())
        .isEqualTo("dfra: there is no robot zetta; did you mean \"zeta\"?");
  }

  @Test
  void eventsAreShownAndMeasured() throws Exception {
    assertThat(output("event", "echo", GPS, "--kind=reading", "--count=2").lines())
        .hasSize(2)
        .allSatisfy(
            line ->
                assertThat(line)
                    .matches("\\S+Z  reading    #\\d+  GpsFix mode FIX_3D, position .*"));
    assertThat(output("event", "echo", GPS, "--count=1", "--kind=reading", "--json").lines())
        .singleElement()
        .asString()
        .contains("\"module\":\"" + GPS + "\"", "\"lost\":0", "\"mode\":\"FIX_3D\"");
    assertThat(output("event", "hz", GPS, "--count=3").lines().reduce((a, b) -> b).orElseThrow())
        .matches("[\\d.]+ Hz; interval min [\\d.]+ s, max [\\d.]+ s, std [\\d.]+ s; 3 events");
    assertThat(output("event", "bw", GPS, "--count=2", "--json").lines().reduce((a, b) -> b))
        .hasValueSatisfying(
            line ->
                assertThat(line).contains("\"events\":2").containsPattern("\"minSize\":\\d{3}"));
    assertThat(output("event", "hz", GPS, "--kind=incident", "--for=0.5").strip())
        .isEqualTo("no event so far");
    assertThat(output("event", "noise", GPS, "--count=3").lines().map(row -> row.split(" ", 2)[0]))
        .containsExactly(
            "PARAMETER", "gps_white_noise_sigma", "gps_bias_sigma", "gps_bias_correlation_time");
    assertThat(output("event", "noise", GPS, "--count=3", "--json"))
        .contains("\"gps_white_noise_sigma\"", "3 fixes");
    Outcome nothing = ask("event", "noise", GPS, "--kind=incident", "--for=0.5");
    assertThat(nothing.exit()).isEqualTo(1);
    assertThat(nothing.err().strip())
        .isEqualTo("dfra: the module sent no readings; see its state: ./dfra module list");
    assertThat(ask("event", "echo", GPS, "--depth=0").exit()).isEqualTo(2);
    await("all of them gave their leases back")
        .atMost(PATIENCE)
        .untilAsserted(() -> assertThat(output("lease", "list")).contains("Nobody"));
  }

  @Test
  void aListenerIsSeenRevokedAndGoneWhenItIsTerminated() throws Exception {
    CompletableFuture<Outcome> listener = askBeside("event", "echo", GPS);
    String unusedFirst = awaitLease();
    assertThat(output("log", "level", GPS)).contains("logs INFO and above");
    assertThat(output("log", "level", GPS, "debug")).contains("logs DEBUG and above");
    assertThat(ask("log", "level", GPS, "loud").exit()).isEqualTo(2);
    String lease = revoke();
    Outcome revoked = listener.get();
    assertThat(revoked.exit()).isEqualTo(1);
    assertThat(revoked.err())
        .contains("dfra: " + GPS + " sends no more events: an administrator has revoked the lease");
    Outcome unknown = ask("lease", "revoke", GPS, lease);
    assertThat(unknown.exit()).isEqualTo(3);

    CompletableFuture<Outcome> interrupted = askBeside("event", "hz", GPS);
    String unused = awaitLease();
    List<ProcessHandle> living = new ArrayList<>(beside.living());
    assertThat(living).hasSize(1);
    assertThat(living.get(0).destroy()).isTrue(); // SIGTERM; Ctrl-C ends a JVM the same way
    assertThat(interrupted.get().exit()).isEqualTo(143);
    await()
        .atMost(PATIENCE)
        .untilAsserted(
            () ->
                assertThat(output("lease", "list", GPS))
                    .isEqualToIgnoringNewLines("Nobody holds a lease on " + GPS + "."));
  }

  /**
   * Revokes the listener's lease, and returns how its name begins. On a computer that is far too
   * busy it may have lost one meanwhile and have another.
   */
  private String revoke() {
    String[] lease = new String[1];
    await()
        .atMost(PATIENCE)
        .until(
            () -> {
              lease[0] = awaitLease();
              Outcome outcome = ask("lease", "revoke", GPS, lease[0]);
              return outcome.exit() == 0 && outcome.out().startsWith("Revoked lease " + lease[0]);
            });
    return lease[0];
  }

  /** How the name of the only lease there is begins. */
  private String awaitLease() {
    String[] found = new String[1];
    await()
        .atMost(PATIENCE)
        .until(
            () -> {
              List<String> rows = output("lease", "list", GPS).lines().skip(1).toList();
              if (rows.size() == 1) {
                String[] cells = rows.get(0).split(" {2,}");
                assertThat(cells).startsWith(GPS, "client", "a program at 127.0.0.1");
                found[0] = cells[cells.length - 1];
              }
              return rows.size() == 1;
            });
    return found[0];
  }
}
