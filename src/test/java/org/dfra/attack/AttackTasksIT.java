package org.dfra.attack;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dfra.attack.kit.AttackHosts;
import org.dfra.benchmarks.attack.AttackTask;
import org.dfra.benchmarks.attack.AttackTask.Target;
import org.dfra.benchmarks.attack.DiscoveryBombs;
import org.dfra.benchmarks.attack.ForgedText;
import org.dfra.benchmarks.attack.GroupRegistrations;
import org.dfra.benchmarks.attack.HonestRobot;
import org.dfra.benchmarks.attack.JrmpReferences;
import org.dfra.benchmarks.attack.LocalMulticast;
import org.dfra.benchmarks.attack.LockTheft;
import org.dfra.benchmarks.attack.MeasuredValueLines;
import org.dfra.benchmarks.attack.NestedXml;
import org.dfra.benchmarks.attack.RegistrarChanges;
import org.dfra.benchmarks.task.TaskProcess;
import org.dfra.report.measurement.MeasuredValue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;

/**
 * The benchmark's attacks that have figures of their own reach its robot and come to nothing. All
 * run at once; what the robot uses meanwhile is the benchmark's to measure.
 */
@Timeout(300)
class AttackTasksIT {

  private static final Duration PATIENCE = Duration.ofSeconds(120);

  @TempDir Path temp;

  @Test
  @EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "many processes")
  void attacksReachTheRobotAndComeToNothing() throws Exception {
    AttackHosts hosts = AttackHosts.assumed();
    boolean hasMulticast = LocalMulticast.isPossible();
    try (TaskProcess robot = robot(hasMulticast)) {
      String[] phoenix = robot.awaitLine("phoenix ", PATIENCE).split(" ");
      robot.killWithThis(Long.parseLong(phoenix[2]));
      Path lock = Path.of(robot.awaitLine("lock ", PATIENCE).substring("lock ".length()));
      String[] ports = robot.awaitLine("registrar ", PATIENCE).split(" ");
      List<Class<? extends AttackTask>> attacks =
          new ArrayList<>(
              List.of(
                  JrmpReferences.class,
                  GroupRegistrations.class,
                  LockTheft.class,
                  RegistrarChanges.class));
      if (hasMulticast) {
        attacks.add(DiscoveryBombs.class);
      }
      // Those that run commands at their end are stopped last, when the others have ended.
      attacks.addAll(List.of(ForgedText.class, NestedXml.class));
      Map<Class<? extends AttackTask>, TaskProcess> attackers = new LinkedHashMap<>();
      try {
        for (Class<? extends AttackTask> each : attacks) {
          Target target =
              new Target(
                  hosts.attacker(),
                  "127.0.0.1",
                  Integer.parseInt(ports[1]),
                  Integer.parseInt(ports[3]),
                  Integer.parseInt(phoenix[1]),
                  lock,
                  Files.createDirectory(temp.resolve(each.getSimpleName())));
          attackers.put(each, start(each, target));
        }
        attackers.forEach(AttackTasksIT::assertHarmless);
        robot.write(HonestRobot.GROUPS);
        assertThat(robot.awaitLine("groups ", PATIENCE)).isEqualTo("groups 1");
      } finally {
        for (TaskProcess each : attackers.values()) {
          each.close();
        }
      }
    }
  }

  private TaskProcess robot(boolean hasMulticast) throws IOException {
    List<String> arguments = new ArrayList<>();
    arguments.add(HonestRobot.PHOENIX + temp.resolve("state"));
    if (hasMulticast) {
      arguments.add(HonestRobot.SEARCH);
    }
    return TaskProcess.start(
        List.of(),
        List.of("-Xmx256m", "-XX:+ExitOnOutOfMemoryError", root()),
        HonestRobot.class,
        arguments.toArray(String[]::new));
  }

  private static String root() {
    return "-Ddfra.root=" + System.getProperty("dfra.root");
  }

  private static TaskProcess start(Class<? extends AttackTask> attack, Target target)
      throws IOException {
    return TaskProcess.start(List.of(), List.of(root()), attack, target.arguments());
  }

  private static void assertHarmless(Class<? extends AttackTask> attack, TaskProcess attacker) {
    List<MeasuredValue> figures;
    try {
      if (attack != ForgedText.class) { // nothing of which is refused
        String unused = attacker.awaitLine("refused ", PATIENCE);
      }
      attacker.write("stop");
      String unusedEither = attacker.awaitLine("done ", PATIENCE);
      figures = MeasuredValueLines.read(attacker.lines());
    } catch (IOException | InterruptedException e) {
      throw new AssertionError(attack + " failed: " + e.getMessage(), e);
    }
    assertThat(figures).as("%s", attack).isNotEmpty();
    if (attack == LockTheft.class) { // as the robot's own user: what is free, it takes
      assertThat(figures).noneMatch(MeasuredValue::isMet);
    } else {
      assertThat(figures).as("%s", attack).allMatch(each -> each.isMet() || each.isTime());
    }
  }
}
