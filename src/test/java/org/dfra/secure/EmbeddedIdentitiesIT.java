package org.dfra.secure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.nio.file.Path;
import java.time.Clock;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.core.config.RobotXml;
import org.dfra.core.policy.BuiltInPolicies;
import org.dfra.core.policy.PolicyGuard;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleQuery;
import org.dfra.drive.Wheels;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.Subscription;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.lease.ModuleLease;
import org.dfra.river.bootstrap.EmbeddedRobot;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.identity.RevokedCertificates;
import org.dfra.river.identity.TeamCredentials;
import org.dfra.river.identity.TeamIdentity;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.security.AccessRefusedException;
import org.dfra.security.AccessRequest;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Two robots of a team in one virtual machine, which has no identity of its own. */
@Timeout(120)
class EmbeddedIdentitiesIT {

  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final String FIRST = "atrv1";
  private static final String SECOND = "atrv2";

  @TempDir Path folder;

  private final Map<String, List<AccessRequest>> served =
      Map.of(FIRST, new CopyOnWriteArrayList<>(), SECOND, new CopyOnWriteArrayList<>());

  /** A robot's identity, with the standard policy. */
  private TeamIdentity robot(SecureTeam team, String name) throws Exception {
    team.admit("robot", name);
    TeamCredentials member = IdentityFolder.load(team.security(name));
    PolicyGuard policy = new PolicyGuard(BuiltInPolicies.standard("field"));
    return new TeamIdentity(
        new TeamIdentity.Settings(
            member.member(),
            new TeamIdentity.Key(member.privateKey(), List.of(member.chain())),
            Set.of(),
            Set.of(),
            member.authority(),
            new RevokedCertificates(member.authority()),
            request -> {
              served.getOrDefault(name, List.of()).add(request);
              return policy.decide(request);
            },
            false),
        Clock.systemUTC());
  }

  private EmbeddedRobot embedded(SecureTeam team, String name, Wheels wheels, TeamIdentity identity)
      throws Exception {
    Path xml =
        team.describe(
            name, TeamRobots.group("all", TeamRobots.registrar(), TeamRobots.drive(wheels.url())));
    return new EmbeddedRobot(RobotXml.read(xml), identity);
  }

  /** A directory of both robots, as a program of a robot opens it. */
  private static ModuleDirectory directory(SecureTeam team) throws Exception {
    return new JiniModuleDirectory(
        SecureTeam.HOST, List.of(), List.of(locator(team, FIRST), locator(team, SECOND)));
  }

  private static String locator(SecureTeam team, String robot) {
    return "jini://" + SecureTeam.HOST + ":" + team.registrar(robot);
  }

  private static DriveEffector drive(ModuleDirectory directory, String robot) throws Exception {
    return directory
        .findFirst(ModuleQuery.of(DriveEffector.class).robot(robot), PATIENCE)
        .orElseThrow()
        .module();
  }

  private Caller last(String robot, String method) {
    return served.getOrDefault(robot, List.of()).stream()
        .filter(each -> each.method().getName().equals(method))
        .reduce((first, second) -> second)
        .orElseThrow()
        .caller();
  }

  @Test
  void eachIsAuthenticatedAsItselfAndOneCannotCommandTheOthersDrive() throws Exception {
    SecureTeam team = new SecureTeam(folder); // no process of it runs
    team.init();
    TeamIdentity first = robot(team, FIRST);
    TeamIdentity second = robot(team, SECOND);
    try (Wheels firstWheels = new Wheels();
        Wheels secondWheels = new Wheels();
        EmbeddedRobot one = embedded(team, FIRST, firstWheels, first);
        EmbeddedRobot other = embedded(team, SECOND, secondWheels, second)) {
      one.start();
      other.start();
      try (ModuleDirectory firsts = CurrentIdentity.callAs(first, () -> directory(team));
          ModuleDirectory seconds = CurrentIdentity.callAs(second, () -> directory(team))) {
        // From here on, no thread says who it is: the proxies know it.
        DriveEffector own = drive(firsts, FIRST);
        DriveEffector others = drive(firsts, SECOND);
        DriveEffector back = drive(seconds, FIRST);
        assertThat(others.driveState()).isNotNull();
        assertThat(last(SECOND, "driveState").member()).contains(first.member());
        assertThat(last(SECOND, "driveState").standing()).isEqualTo(Standing.MEMBER);
        assertThat(back.driveState()).isNotNull();
        assertThat(last(FIRST, "driveState").member()).contains(second.member());

        assertThatThrownBy(() -> others.acquireCommandLease(Duration.ofSeconds(5)))
            .isInstanceOf(AccessRefusedException.class)
            .hasMessageContaining("drive is refused to robot atrv1 of field");
        assertThatThrownBy(() -> back.acquireCommandLease(Duration.ofSeconds(5)))
            .isInstanceOf(AccessRefusedException.class)
            .hasMessageContaining("drive is refused to robot atrv2 of field");
        own.acquireCommandLease(Duration.ofSeconds(5)).close();

        AtomicInteger events = new AtomicInteger();
        try (Subscription listening =
                others.subscribe(event -> events.incrementAndGet(), DeliveryPolicy.keepLast(8));
            ModuleLease held = others.acquireLease(Duration.ofSeconds(1))) {
          others.emergencyStop("the end of the test");
          await().atMost(PATIENCE).until(() -> events.get() > 0);
          await().atMost(PATIENCE).until(() -> isRenewed());
          assertThat(last(SECOND, "renew").member()).contains(first.member());
        }
      }
    }
    for (String each : List.of(FIRST, SECOND)) {
      assertThat(served.getOrDefault(each, List.of()))
          .as("calls of nobody at %s", each)
          .isNotEmpty()
          .allSatisfy(call -> assertThat(call.caller().standing()).isNotEqualTo(Standing.STRANGER));
    }
  }

  private boolean isRenewed() {
    return served.getOrDefault(SECOND, List.of()).stream()
        .anyMatch(each -> each.method().getName().equals("renew"));
  }
}
