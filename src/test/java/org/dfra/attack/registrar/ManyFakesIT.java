package org.dfra.attack.registrar;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.dfra.attack.kit.AttackHosts;
import org.dfra.attack.kit.AttackedRobot;
import org.dfra.attack.kit.FakeServices;
import org.dfra.attack.kit.Fakes;
import org.dfra.benchmarks.task.TaskProcess;
import org.dfra.core.time.StallProbe;
import org.dfra.directory.ModuleQuery;
import org.dfra.drive.Wheels;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.river.bootstrap.EmbeddedRobot;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * A stranger registers 3000 fakes (in the everyday tier 300), each of a robot of its own, in a
 * robot's registrar. It takes 256 of them; a client that comes then finds the robot's drive within
 * 3 s, and what the robot registers itself is taken.
 */
@Timeout(180)
class ManyFakesIT {

  private static final Duration PATIENCE = Duration.ofSeconds(90);
  private static final Duration BOUND = Duration.ofSeconds(3);
  private static final int FAKES = Boolean.getBoolean("dfra.full") ? 3000 : 300;
  private static final int TAKEN = 256;

  @TempDir Path folder;

  private final AttackHosts hosts = AttackHosts.assumed();
  private final StallProbe probe = StallProbe.start();
  private Wheels wheels;
  private EmbeddedRobot robot;
  private TaskProcess task;

  @BeforeEach
  void bringUp() throws Exception {
    wheels = new Wheels();
    robot = AttackedRobot.of(folder, hosts.robot(), "", wheels);
    robot.start();
    task = AttackedRobot.attacker(FakeServices.class, hosts.robot(), robot.registrar().port());
  }

  @AfterEach
  void takeDown() throws Exception {
    try (Wheels stopped = wheels;
        EmbeddedRobot ended = robot;
        TaskProcess killed = task;
        StallProbe done = probe) {
      assertThat(killed == null || killed.isAlive()).as("the attacker").isTrue();
    }
  }

  @Test
  void doNotHideTheRobot() throws Exception {
    task.write(hosts.attacker() + " many " + FAKES);
    assertThat(task.awaitLine("{", PATIENCE))
        .isEqualTo("{RegistrationRefusedException=%d, done=%d}".formatted(FAKES - TAKEN, TAKEN));
    assertFound();
    task.write(hosts.otherAttacker() + " claim theta");
    assertThat(task.awaitLine("", PATIENCE)).as("another robot's module").isEqualTo("done");
    Object unused =
        Fakes.register(robot.registrar().registrar(), null, "own", Fakes.module("eta", "gps"));
  }

  private void assertFound() throws Exception {
    StallProbe.Stopwatch watch = probe.stopwatch();
    try (JiniModuleDirectory directory =
        new JiniModuleDirectory(hosts.robot(), List.of(), List.of(robot.registrar().locator()))) {
      assertThat(directory.findFirst(ModuleQuery.of(DriveEffector.class).robot("eta"), PATIENCE))
          .isPresent();
      watch.stop().requireWithin("finding the drive beside " + FAKES + " fakes", BOUND);
    }
  }
}
