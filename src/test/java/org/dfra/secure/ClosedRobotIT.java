package org.dfra.secure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;
import static org.dfra.secure.SecureTeam.ANNA;
import static org.dfra.secure.SecureTeam.ok;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.rmi.RemoteException;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.app.MarkedProcesses.Outcome;
import org.dfra.authority.Authority;
import org.dfra.cli.security.IdentityInstaller;
import org.dfra.cli.security.VerifiedBundle;
import org.dfra.drive.Wheels;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.river.phoenix.GroupStatus;
import org.dfra.secure.PlainCalls.Greeted;
import org.dfra.security.AccessRefusedException;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;

/**
 * A robot whose identity cannot be used comes up closed: its own processes use it, others can only
 * stop it. It is never open, and says why.
 */
@Timeout(240)
class ClosedRobotIT {

  private static final ServiceTemplate ALL = new ServiceTemplate(null, null, null);
  private static final String ROBOT = "atrv1";
  private static final String BEN = "ben";
  private static final String STRANGER = "stranger";

  @TempDir Path folder;

  private SecureTeam team;
  private Wheels wheels;

  @BeforeEach
  void make() throws Exception {
    wheels = new Wheels();
    team = new SecureTeam(folder);
    team.describe(
        ROBOT, TeamRobots.group("all", TeamRobots.registrar(), TeamRobots.drive(wheels.url())));
  }

  @AfterEach
  void end() {
    try {
      team.close();
    } finally {
      wheels.close();
    }
  }

  private void joined() throws Exception {
    team.init();
    team.admit("robot", ROBOT);
  }

  private Path file(String name) {
    return team.security(ROBOT).resolve(name);
  }

  private String phoenix() throws Exception {
    return "--phoenix=" + SecureTeam.HOST + ":" + team.phoenix(ROBOT).port();
  }

  /** What is the same for all of them. */
  private void assertClosed(String why) throws Exception {
    Outcome up = ok(team.up(ROBOT));
    assertThat(up.err()).contains(why).startsWith("dfra: ").doesNotContain("\tat ");
    assertThat(up.out()).as("the fault is said once").doesNotContain(why);
    assertThat(ok(team.dfra(ROBOT, "status")).out())
        .contains("Closed: robot atrv1 of field works for itself only, since ")
        .contains(why);
    for (ProcessHandle process : team.living(ROBOT)) {
      Map<Integer, Greeted> answers = PlainCalls.toAllPortsOf(process.pid());
      assertThat(answers.values())
          .as("answers of %s to plain calls: %s", process.info().commandLine(), answers)
          .contains(Greeted.ENCRYPTED_ONLY)
          .doesNotContain(Greeted.WELCOME, Greeted.RIVER);
    }
    assertThat(ok(team.ask(ROBOT, "module", "call", "atrv1/drive", "driveState")).out())
        .contains("velocity");
  }

  /** What a closed process says of its identity, and what was done to the identity. */
  private record Fault(String why, Spoiling spoiling) {}

  @FunctionalInterface
  private interface Spoiling {
    void spoil() throws Exception;
  }

  private Fault aWrongPassphrase() {
    return new Fault(
        "identity.p12 is wrong; correct identity.pass beside it",
        () -> {
          Path unused = Files.writeString(file("identity.pass"), "wrong\n");
        });
  }

  private List<Fault> otherFaults(Path otherAuthority) {
    return List.of(
        new Fault(
            "comes with that of another authority",
            () -> {
              Path unused =
                  Files.copy(
                      otherAuthority, file("authority.pem"), StandardCopyOption.REPLACE_EXISTING);
            }),
        new Fault(
            "the policy's signature is not that of CN=field authority",
            () -> {
              Path unused = Files.writeString(file("policy.xml"), "<policy");
            }),
        new Fault(
            "which must be private; type: chmod 600",
            () -> {
              Path unused =
                  Files.setPosixFilePermissions(
                      file("identity.p12"), PosixFilePermissions.fromString("rw-r--r--"));
            }));
  }

  @Test
  void aWrongPassphraseClosesARobotAndSoDoesEachOtherFault() throws Exception {
    joined();
    MemberCalls itself = new MemberCalls(team.security(ROBOT));
    Path intact = copyOf(team.security(ROBOT), folder.resolve("intact"));
    Fault first = aWrongPassphrase();
    first.spoiling().spoil();
    assertClosed(first.why());
    DriveEffector own = itself.find(team.registrar(ROBOT), DriveEffector.class, "atrv1/drive");
    assertThatThrownBy(() -> MemberCalls.registrar(team.registrar(ROBOT)).lookup(ALL, 8))
        .isInstanceOf(AccessRefusedException.class);
    team.admit("operator", BEN);
    Outcome stop = team.dfra(BEN, "stop", ROBOT, "--team=", "--host=127.0.0.1", phoenix());
    assertThat(itself.call(own::emergencyStopState).latched()).as("%s", stop).isTrue();
    assertThat(stop.out()).as("nobody knows who has answered").contains("DOUBTFUL");
    ok(team.dfra(ROBOT, "stop", ROBOT, "--team=", "--host=127.0.0.1", phoenix()));
    if (Boolean.getBoolean("dfra.full")) {
      try (SecureTeam others = new SecureTeam(folder.resolve("others"))) {
        others.init();
        for (Fault each : otherFaults(others.security(ANNA).resolve("authority.pem"))) {
          Path unused = copyOf(intact, team.security(ROBOT));
          each.spoiling().spoil();
          assertClosedAgain(each.why());
        }
      }
    }
  }

  /** Its group starts again, with another fault than before. */
  private void assertClosedAgain(String why) throws Exception {
    MemberCalls itself = MemberCalls.alone(folder.resolve("intact"));
    DriveEffector drive = itself.find(team.registrar(ROBOT), DriveEffector.class, "atrv1/drive");
    GroupStatus before = itself.call(this::group);
    SecureTeam.kill(ProcessHandle.of(before.pid()).orElseThrow());
    await()
        .pollInSameThread()
        .atMost(SecureTeam.PATIENCE)
        .ignoreExceptionsMatching(RemoteException.class::isInstance)
        .until(() -> itself.call(() -> drive.emergencyStopState().latched()));
    GroupStatus now = itself.call(this::group);
    assertThat(now.pid()).isNotEqualTo(before.pid());
    Map<Integer, Greeted> answers = PlainCalls.toAllPortsOf(now.pid());
    assertThat(answers.values())
        .as("answers to plain calls, since %s: %s", why, answers)
        .contains(Greeted.ENCRYPTED_ONLY)
        .doesNotContain(Greeted.WELCOME, Greeted.RIVER);
    assertThatThrownBy(() -> MemberCalls.registrar(team.registrar(ROBOT)).lookup(ALL, 8))
        .as("a stranger, since %s", why)
        .isInstanceOf(AccessRefusedException.class);
    assertThat(ok(team.dfra(ROBOT, "status")).out())
        .contains("Closed: robot atrv1 of field works for itself only, since ")
        .contains(why);
  }

  private GroupStatus group() throws IOException {
    return team.phoenix(ROBOT).admin().groupStatus().stream()
        .filter(each -> each.name().endsWith(".all"))
        .findFirst()
        .orElseThrow();
  }

  /** Copies the files of a folder, with their permissions. */
  private static Path copyOf(Path from, Path to) throws Exception {
    Path unusedFolder = privateFolder(to);
    try (Stream<Path> files = Files.list(from)) {
      for (Path each : files.filter(Files::isRegularFile).toList()) {
        Path unused =
            Files.copy(
                each,
                to.resolve(each.getFileName()),
                StandardCopyOption.REPLACE_EXISTING,
                StandardCopyOption.COPY_ATTRIBUTES);
      }
    }
    return to;
  }

  @Test
  @EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "one more robot")
  void anExpiredRobotWorksForItselfAndOthersCanOnlyStopIt() throws Exception {
    Instant past = Instant.now().minus(Duration.ofDays(10));
    Clock then = Clock.fixed(past, ZoneOffset.UTC);
    Path authority = privateFolder(team.state(ANNA)).resolve("authority");
    Authority.create(authority, "field", "open sesame", true, then);
    try (Authority opened = Authority.open(authority, () -> "", then)) {
      Authority.IssuedBundle issued = opened.issue(MemberRole.ROBOT, ROBOT, Duration.ofDays(1));
      new IdentityInstaller(privateFolder(team.state(ROBOT)))
          .install(
              VerifiedBundle.open(issued.bundle(), issued.passphrase(), "bundle"),
              "bundle",
              past,
              false);
    }
    team.admit("operator", BEN);
    assertClosed("expired");
    Outcome call = team.ask(BEN, "module", "call", "atrv1/drive", "driveState", "--wait=3");
    assertThat(call.exit()).as(call.out() + call.err()).isNotZero();
    Outcome stranger =
        team.ask(STRANGER, "module", "call", "atrv1/drive", "driveState", "--wait=3");
    assertThat(stranger.exit()).as(stranger.out() + stranger.err()).isNotZero();
    assertThat(ok(team.dfra(BEN, "stop", ROBOT, "--team=", "--host=127.0.0.1", phoenix())).out())
        .contains("1 effector: 1 stopped.");
    Outcome release = team.ask(BEN, "stop", ROBOT, "--release", "--wait=3");
    assertThat(release.exit()).as(release.out() + release.err()).isNotZero();
    ok(team.ask(ROBOT, "stop", ROBOT, "--release"));
  }

  private static Path privateFolder(Path path) throws Exception {
    return Files.setPosixFilePermissions(
        Files.createDirectories(path), PosixFilePermissions.fromString("rwx------"));
  }
}
