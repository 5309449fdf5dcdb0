package org.dfra.secure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;
import static org.dfra.secure.SecureTeam.ANNA;
import static org.dfra.secure.SecureTeam.ok;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.app.MarkedProcesses.Outcome;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.drive.Commander;
import org.dfra.drive.Wheels;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.security.AccessRefusedException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Operator anna lets robot atrv1 command robot atrv2 on her behalf, by the command line, and its
 * commands move the wheels until she is revoked.
 */
@Timeout(300)
class DelegationIT {

  private static final String FIRST = "atrv1";
  private static final String SECOND = "atrv2";
  private static final String THIRD = "atrv3";
  private static final Duration LEASE = Duration.ofSeconds(20);
  private static final Duration SECOND_AFTER = Duration.ofSeconds(1);
  private static final Duration BRAKING = Duration.ofMillis(500);
  private static final Pattern FINGERPRINT = Pattern.compile("([0-9A-F]{2}:){31}[0-9A-F]{2}");

  @TempDir Path folder;

  private static void assertRefused(Outcome outcome, String words) {
    assertThat(outcome.exit()).as(outcome.out() + outcome.err()).isEqualTo(1);
    assertThat(outcome.err().strip()).startsWith("dfra: ").contains(words).hasLineCount(1);
  }

  private static String fingerprint(SecureTeam team, String who) {
    Matcher found = FINGERPRINT.matcher(ok(team.here(who, "whoami")).out());
    assertThat(found.find()).isTrue();
    return found.group();
  }

  @Test
  void aRobotCommandsAnotherForAnOperatorUntilSheIsRevoked() throws Exception {
    Path file = folder.resolve("anna-for-atrv1.delegation");
    String[] command = {"module", "call", "atrv2/route", "cancel"};
    try (Wheels wheels = new Wheels();
        SecureTeam team = new SecureTeam(folder)) {
      team.init();
      for (String each : new String[] {FIRST, SECOND, THIRD}) {
        team.admit("robot", each);
      }
      team.describe(
          SECOND,
          TeamRobots.group(
              "all", TeamRobots.registrar(), TeamRobots.drive(wheels.url()), TeamRobots.route()));
      ok(team.up(SECOND));
      assertRefused(team.ask(FIRST, command), "cancel of route is refused to robot atrv1");

      Outcome made =
          ok(
              team.here(
                  ANNA,
                  "security",
                  "delegate",
                  "robot",
                  FIRST,
                  "--robots=" + SECOND,
                  "--for=30m",
                  "--fingerprint=" + fingerprint(team, FIRST),
                  "--out=" + file));
      assertThat(made.out()).contains("robot atrv1 of field may command atrv2 on your behalf");
      assertRefused(
          team.here(THIRD, "security", "accept", file.toString()),
          "is for robot atrv1 of field, and this computer is robot atrv3 of field");
      ok(team.here(FIRST, "security", "accept", file.toString()));
      assertThat(ok(team.here(FIRST, "whoami")).out())
          .contains("May command atrv2 for operator anna of field until ");
      ok(team.ask(FIRST, command));

      Path stolen = team.security(THIRD).resolve("operator-anna.delegation");
      Files.copy(file, stolen);
      assertRefused(team.ask(THIRD, command), "is refused to robot atrv3 of field (127.0.0.1)");
      ok(team.ask(FIRST, "stop", SECOND));
      Outcome release = team.ask(FIRST, "stop", SECOND, "--release");
      assertThat(release.out() + release.err())
          .contains("releaseEmergencyStop of drive is refused");
      ok(team.ask(ANNA, "stop", SECOND, "--release"));
      assertThat(ok(team.here(SECOND, "audit", "--who=anna")).out())
          .contains("robot atrv1 of field for operator anna of field", "delegates, operators");

      untilSheIsRevoked(team, wheels);
      assertRefused(team.ask(FIRST, command), "certificate of operator anna of field is revoked");
    }
  }

  private static void untilSheIsRevoked(SecureTeam team, Wheels wheels) throws Exception {
    MemberCalls first = new MemberCalls(team.security(FIRST));
    first.carryDelegations(team.security(FIRST));
    DriveEffector drive = first.find(team.registrar(SECOND), DriveEffector.class, "atrv2/drive");
    try (StallProbe probe = StallProbe.start();
        Commander commander = first.call(() -> new Commander(drive, LEASE, new Velocity(0.4, 0)))) {
      await().atMost(SecureTeam.PATIENCE).until(() -> wheels.speed() > 0.3);
      StallProbe.Stopwatch watch = probe.stopwatch();
      team.revoke(ANNA, SECOND);
      await()
          .pollInterval(Duration.ofMillis(20))
          .atMost(SecureTeam.PATIENCE)
          .until(() -> wheels.speed() < 0.01);
      Timing halt = watch.stop();
      await()
          .pollInterval(Duration.ofMillis(20))
          .atMost(SecureTeam.PATIENCE)
          .until(() -> first.call(drive::driveState).commander() == null);
      Timing lease = watch.stop();
      System.out.println("the operator is revoked: wheels " + halt + ", lease over " + lease);
      halt.requireWithin("from the revocation to wheels that stand", SECOND_AFTER.plus(BRAKING));
      lease.requireWithin(
          "from the revocation to the end of the lease", SECOND_AFTER.plus(BRAKING));
      assertThat(commander.hasGivenUp()).isTrue();
      assertThatThrownBy(() -> first.call(() -> drive.acquireCommandLease(LEASE)))
          .isInstanceOf(AccessRefusedException.class)
          .hasMessageContaining("certificate of operator anna of field is revoked");
    }
  }
}
