package org.dfra.secure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.secure.SecureTeam.ANNA;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.ZoneOffset;
import org.dfra.app.MarkedProcesses.Outcome;
import org.dfra.authority.Authority;
import org.dfra.cli.security.IdentityInstaller;
import org.dfra.cli.security.VerifiedBundle;
import org.dfra.drive.Wheels;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(300)
class ClosedRobotIT {
  private static final Duration BEFORE = Duration.ofDays(10);

  @TempDir static Path folder;
  private static SecureTeam team;
  private static Wheels wheels;

  @BeforeAll
  static void make() throws Exception {
    wheels = new Wheels();
    team = new SecureTeam(folder);
    Instant past = Instant.now().minus(BEFORE);
    Path authority = team.state(ANNA).resolve("authority");
    Files.createDirectories(team.state(ANNA));
    Files.setPosixFilePermissions(team.state(ANNA), java.nio.file.attribute.PosixFilePermissions.fromString("rwx------"));
    Clock then = Clock.fixed(past, ZoneOffset.UTC);
    Authority.create(authority, "field", "open sesame", true, then);
    Files.createDirectories(team.state("old"));
    Files.setPosixFilePermissions(team.state("old"), java.nio.file.attribute.PosixFilePermissions.fromString("rwx------"));
    try (Authority opened = Authority.open(authority, () -> "", then)) {
      var issued = opened.issue(MemberRole.ROBOT, "old", Duration.ofDays(1));
      new IdentityInstaller(team.state("old")).install(VerifiedBundle.open(issued.bundle(), issued.passphrase(), "b"), "b", past, false);
    }
    team.admit("operator", "ann");
    for (String r : new String[]{"pass", "pem", "policy", "key", "old"}) {
      if (!r.equals("old")) team.admit("robot", r);
      team.describe(r, TeamRobots.group("all", TeamRobots.registrar(), TeamRobots.drive(wheels.url())));
    }
    Files.writeString(team.security("pass").resolve("identity.pass"), "wrong\n");
    try (SecureTeam others = new SecureTeam(folder.resolve("o"))) { others.init();
      Files.copy(others.security(ANNA).resolve("authority.pem"), team.security("pem").resolve("authority.pem"), java.nio.file.StandardCopyOption.REPLACE_EXISTING); }
    Files.writeString(team.security("policy").resolve("policy.xml"), "<policy");
    Files.setPosixFilePermissions(team.security("key").resolve("identity.p12"), java.nio.file.attribute.PosixFilePermissions.fromString("rw-r--r--"));
  }

  @AfterAll
  static void end() { team.close(); wheels.close(); }

  @Test
  void look() throws Exception {
    for (String r : new String[]{"old", "pem", "pass"}) {
      Outcome up = team.up(r);
      System.out.println("== " + r + " up " + up);
      for (ProcessHandle p : team.living(r)) System.out.println("   " + p.pid() + " " + PlainCalls.toAllPortsOf(p.pid()));
      if (up.exit() == 0) {
      System.out.println("status " + team.dfra(r, "status"));
      System.out.println("own call " + team.ask(r, "module", "call", r + "/drive", "driveState"));
      System.out.println("ann call " + team.ask("ann", "module", "call", r + "/drive", "driveState", "--wait=4"));
      System.out.println("ann stop " + team.ask("ann", "stop", r, "--wait=4"));
      System.out.println("stranger stop " + team.ask("nobody", "stop", r, "--wait=4"));
      System.out.println("stranger call " + team.ask("nobody", "module", "call", r + "/drive", "driveState", "--wait=4")); }
      team.living(r).forEach(ProcessHandle::destroyForcibly);
    }
  }
}
