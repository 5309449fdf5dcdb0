package org.dfra.secure;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.benchmarks.attack.AttackCase;
import org.dfra.benchmarks.attack.AttackTask.Target;
import org.dfra.benchmarks.attack.HonestRobot;
import org.dfra.benchmarks.attack.LocalMulticast;
import org.dfra.benchmarks.attack.MeasuredValueLines;
import org.dfra.benchmarks.secure.BenchTeam;
import org.dfra.benchmarks.task.TaskProcess;
import org.dfra.drive.Commander;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.module.LogLevel;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.river.security.SecureProcess;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;

/**
 * The attacks of {@code ./dfra bench attack} again, by a member of the lowest role against a robot
 * of its team, all at once. An operator drives meanwhile.
 */
@Timeout(300)
@EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "many processes")
class ObserverAttacksIT {

  private static final Duration PATIENCE = Duration.ofSeconds(120);
  private static final Duration LEASE = Duration.ofSeconds(20);
  private static final double SPEED = 0.2;

  /** The first call of these is refused by the policy, or by the robot's transport. */
  private static final Set<String> REFUSED =
      Set.of(
          "fake modules", "administrative calls", "registered groups", "changes of the registrar");

  /** What comes of it depends on the robot, which first has to ask the attacker. */
  private static final String ASKED = "discovery bombs";

  /** It needs another user, and no certificate changes what that one may lock. */
  private static final Set<String> NOT_BY_CALLS = Set.of("stolen locks");

  @TempDir Path temp;

  private final Map<AttackCase, TaskProcess> attackers = new LinkedHashMap<>();

  @Test
  void theAttacksOfAnObserverComeToNothing() throws Exception {
    Path state = temp.resolve("state");
    Path annas;
    Path ottos;
    try (BenchTeam team = BenchTeam.create(temp.resolve("authority"))) {
      Path unused = team.join(state, MemberRole.ROBOT, "atrv1");
      annas = team.join(temp.resolve("anna"), MemberRole.OPERATOR, "anna");
      ottos = team.join(temp.resolve("otto"), MemberRole.OBSERVER, "otto");
    }
    try (TaskProcess robot = robot(state)) {
      String[] phoenix = robot.awaitLine("phoenix ", PATIENCE).split(" ");
      robot.killWithThis(Long.parseLong(phoenix[2]));
      Path lock = Path.of(robot.awaitLine("lock ", PATIENCE).substring("lock ".length()));
      String[] ports = robot.awaitLine("registrar ", PATIENCE).split(" ");
      int registrar = Integer.parseInt(ports[1]);
      MemberCalls anna = new MemberCalls(annas);
      DriveEffector drive = anna.find(registrar, DriveEffector.class, "atrv1/drive");
      LogLevel level = drive.logLevel();
      int listed = listed(anna, registrar);
      assertThat(listed).isPositive();
      try (Commander commander =
          anna.call(() -> new Commander(drive, LEASE, new Velocity(SPEED, 0)))) {
        for (AttackCase each : AttackCase.ALL) {
          if (isPossible(each)) {
            Target target =
                new Target(
                    "127.0.0.66",
                    "127.0.0.1",
                    registrar,
                    Integer.parseInt(ports[3]),
                    Integer.parseInt(phoenix[1]),
                    lock,
                    Files.createDirectory(temp.resolve(each.task().getSimpleName())));
            attackers.put(each, start(each, target, ottos));
          }
        }
        attackers.forEach(ObserverAttacksIT::assertHarmless);
        assertThat(commander.hasGivenUp()).as("the operator's command").isFalse();
        assertThat(drive.driveState().commander()).isNotNull();
      }
      assertThat(drive.logLevel()).isEqualTo(level);
      assertThat(listed(anna, registrar)).as("registered services").isEqualTo(listed);
      robot.write(HonestRobot.GROUPS);
      assertThat(robot.awaitLine("groups ", PATIENCE)).isEqualTo("groups 1");
    } finally {
      for (TaskProcess each : attackers.values()) {
        each.close();
      }
    }
  }

  private static int listed(MemberCalls caller, int registrar) throws Exception {
    return caller.call(
        () ->
            MemberCalls.registrar(registrar)
                .lookup(new ServiceTemplate(null, null, null), 10_000)
                .totalMatches);
  }

  private static boolean isPossible(AttackCase attack) {
    return !NOT_BY_CALLS.contains(attack.name())
        && (!attack.isByMulticast() || LocalMulticast.isPossible());
  }

  private static TaskProcess robot(Path state) throws IOException {
    List<String> arguments = new ArrayList<>(List.of(HonestRobot.PHOENIX + state));
    if (LocalMulticast.isPossible()) {
      arguments.add(HonestRobot.SEARCH);
    }
    return TaskProcess.start(
        List.of(),
        List.of("-Xmx256m", "-XX:+ExitOnOutOfMemoryError", root(), security(state)),
        HonestRobot.class,
        arguments.toArray(String[]::new));
  }

  private static String root() {
    return "-Ddfra.root=" + System.getProperty("dfra.root");
  }

  private static String security(Path state) {
    return "-D" + SecureProcess.PROPERTY + "=" + SecureProcess.folder(state);
  }

  private static TaskProcess start(AttackCase attack, Target target, Path security)
      throws IOException {
    return TaskProcess.start(
        List.of(),
        List.of(root(), "-D" + SecureProcess.PROPERTY + "=" + security),
        attack.task(),
        target.arguments());
  }

  private static void assertHarmless(AttackCase attack, TaskProcess attacker) {
    try {
      String unused = attacker.awaitLine("begins", PATIENCE);
      if (REFUSED.contains(attack.name()) || attack.name().equals(ASKED)) {
        System.out.println(attack.name() + ": " + attacker.awaitLine("refused ", PATIENCE));
      }
      attacker.write("stop");
      String[] done = attacker.awaitLine("done ", PATIENCE).split(" ", 4);
      System.out.printf("%s: %s calls, %s refused, %s%n", attack.name(), done[1], done[2], done[3]);
      if (REFUSED.contains(attack.name())) {
        assertThat(done[2]).as("%s: refused calls", attack.name()).isEqualTo(done[1]);
      }
      List<MeasuredValue> figures = MeasuredValueLines.read(attacker.lines());
      assertThat(figures).as("%s", attack.name()).allMatch(each -> each.isMet() || each.isTime());
    } catch (IOException | InterruptedException e) {
      throw new AssertionError(attack.name() + " failed: " + e.getMessage(), e);
    }
  }
}
