package org.dfra.secure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.secure.SecureTeam.ANNA;
import static org.dfra.secure.SecureTeam.ok;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.CompletableFuture;
import org.dfra.app.MarkedProcesses.Outcome;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.drive.Wheels;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.device.gps.M12Emulator;
import org.dfra.sim.device.gps.M12EmulatorSettings;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Two robots, an operator and an observer of a team, and a stranger: what each of them may do by
 * the command line. The tests share the team; the last ones change it.
 */
@Timeout(300)
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class SecureTeamIT {

  private static final Duration TO_A_TEAM = Duration.ofSeconds(60);
  private static final String FIRST = "atrv1";
  private static final String SECOND = "atrv2";
  private static final String OTTO = "otto";
  private static final String STRANGER = "stranger";

  @TempDir static Path folder;

  private static SecureTeam team;
  private static Wheels wheels;
  private static M12Emulator receiver;

  @BeforeAll
  static void make() throws Exception {
    wheels = new Wheels();
    receiver =
        new M12Emulator(
            M12EmulatorSettings.at(new GeoPosition(27.98, -82.45, 14)).withBaud(115_200),
            Instant::now);
    receiver.start();
    team = new SecureTeam(folder);
    team.describe(
        FIRST,
        TeamRobots.group("lookup", TeamRobots.registrar())
            + TeamRobots.group(
                "body", TeamRobots.drive(wheels.url()), TeamRobots.gps(receiver.url())));
    team.describe(
        SECOND, TeamRobots.group("all", TeamRobots.registrar(), TeamRobots.thermometer(17)));
    try (StallProbe probe = StallProbe.start()) {
      StallProbe.Stopwatch watch = probe.stopwatch();
      ok(team.dfra(ANNA, "security", "init", "field", "--no-passphrase", "--operator=" + ANNA));
      for (String robot : new String[] {FIRST, SECOND}) {
        ok(team.dfra(ANNA, team.issueWords("robot", robot)));
        ok(team.dfra(robot, team.joinWords(robot)));
      }
      CompletableFuture<Outcome> first = inBackground(FIRST);
      ok(team.up(SECOND));
      ok(first.get());
      assertThat(ok(team.ask(FIRST, "module", "call", "atrv2/warmth", "celsius")).out())
          .contains("17");
      Timing took = watch.stop();
      System.out.println("from nothing to a call between two robots of a team: " + took);
      took.requireWithin("from nothing to a call between two robots of a team", TO_A_TEAM);
    }
    team.admit("observer", OTTO);
  }

  private static CompletableFuture<Outcome> inBackground(String robot) {
    return CompletableFuture.supplyAsync(
        () -> {
          try {
            return team.up(robot);
          } catch (Exception e) {
            throw new IllegalStateException(e);
          }
        },
        task -> new Thread(task, "up of " + robot).start());
  }

  @AfterAll
  static void end() {
    try {
      team.close();
    } finally {
      receiver.close();
      wheels.close();
    }
  }

  /** One sentence, without a stack trace. */
  private static void assertRefused(Outcome outcome, String... words) {
    assertThat(outcome.exit()).as(outcome.out() + outcome.err()).isEqualTo(1);
    assertThat(outcome.err().strip()).startsWith("dfra: ").contains(words).hasLineCount(1);
  }

  @Test
  @Order(1)
  void anOperatorSetsAParameterAndAnObserverOnlyReadsAndListens() throws Exception {
    ok(team.ask(ANNA, "module", "set", "atrv1/drive", "max_speed", "0.5"));
    assertThat(ok(team.ask(OTTO, "module", "get", "atrv1/drive", "max_speed")).out())
        .contains("0.5");
    assertThat(
            ok(team.ask(OTTO, "event", "echo", "atrv1/gps_front", "--kind=reading", "--count=1"))
                .out())
        .contains("GpsFix");
    assertRefused(
        team.ask(OTTO, "module", "set", "atrv1/drive", "max_speed", "0.7"),
        "setParameter of drive is refused to observer otto of field (127.0.0.1)");
    assertRefused(
        team.ask(OTTO, "module", "call", "atrv1/drive", "acquireCommandLease", "5"),
        "acquireCommandLease of drive is refused to observer otto of field (127.0.0.1)");
    assertThat(ok(team.ask(ANNA, "module", "get", "atrv1/drive", "max_speed")).out())
        .contains("0.5");
  }

  @Test
  @Order(2)
  void aStrangerSeesThePublicPersonaOnly() throws Exception {
    assertThat(ok(team.ask(STRANGER, "module", "list")).out())
        .contains("atrv1", "drive", "gps_front", "atrv2", "warmth");
    assertRefused(
        team.ask(STRANGER, "module", "call", "atrv2/warmth", "celsius"),
        "celsius of warmth is refused to a stranger (127.0.0.1)");
    assertRefused(
        team.ask(STRANGER, "event", "echo", "atrv1/gps_front", "--count=1"),
        "subscribe of gps_front is refused to a stranger (127.0.0.1)");
    assertRefused(
        team.ask(STRANGER, "module", "call", "atrv1/drive", "acquireCommandLease", "5"),
        "acquireCommandLease of drive is refused to a stranger (127.0.0.1)");
    Outcome stop = team.ask(STRANGER, "stop", FIRST);
    assertThat(stop.exit()).as(stop.out() + stop.err()).isNotZero();
    System.out.println("a stranger's stop: " + stop);
    assertThat(stop.out() + stop.err()).doesNotContain("\tat ");
  }

  @Test
  @Order(3)
  void aRobotStopsAnotherAndAnOperatorReleasesIt() throws Exception {
    ok(team.ask(SECOND, "stop", FIRST));
    Outcome release = team.ask(SECOND, "stop", FIRST, "--release");
    System.out.println("a robot's release: " + release);
    assertThat(release.exit()).as(release.out() + release.err()).isNotZero();
    assertThat(release.out() + release.err())
        .contains("is refused to robot atrv2 of field")
        .doesNotContain("\tat ");
    assertThat(ok(team.ask(ANNA, "module", "call", "atrv1/drive", "emergencyStopState")).out())
        .contains("true");
    ok(team.ask(ANNA, "stop", FIRST, "--release"));
  }
}
