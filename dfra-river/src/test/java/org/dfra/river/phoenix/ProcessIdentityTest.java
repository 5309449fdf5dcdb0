package org.dfra.river.phoenix;

import static java.util.concurrent.TimeUnit.SECONDS;
import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** A process is told from a later one with the same number. */
@EnabledOnOs({OS.LINUX, OS.MAC})
class ProcessIdentityTest {

  private Process child;

  @BeforeEach
  void start() throws Exception {
    child = new ProcessBuilder("sleep", "300").start();
  }

  @AfterEach
  void end() throws Exception {
    child.destroyForcibly().waitFor();
  }

  @Test
  void livingProcessIsAlive() {
    ProcessIdentity identity = ProcessIdentity.of(child.toHandle());
    assertThat(identity.isAlive()).isTrue();
    assertThat(identity).isEqualTo(ProcessIdentity.of(child.toHandle()));
    assertThat(identity.awaitDeath(Duration.ofMillis(50))).as("ended within 50 ms").isFalse();
  }

  @Test
  void anotherProcessWithTheSameNumberIsNotTheSameAndIsLeftAlone() {
    ProcessIdentity former = new ProcessIdentity(child.pid(), "tick 1 of boot before");
    assertThat(former.isAlive()).isFalse();
    former.destroy(true);
    assertThat(former.awaitDeath(Duration.ZERO)).isTrue();
    assertThat(child.isAlive()).as("the process that has the number now").isTrue();
  }

  @Test
  void killedProcessIsDeadAndItsDeathAwaited() {
    ProcessIdentity identity = ProcessIdentity.of(child.toHandle());
    identity.destroy(true);
    assertThat(identity.awaitDeath(Duration.ofSeconds(10))).isTrue();
    assertThat(identity.isAlive()).isFalse();
    identity.destroy(true); // of no consequence
  }

  @Test
  void stoppedProcessIsAliveAndEndsByForce() throws Exception {
    new ProcessBuilder("kill", "-STOP", Long.toString(child.pid())).start().waitFor();
    // Until it has stopped, the next signal may overtake the first.
    Path stat = Path.of("/proc", Long.toString(child.pid()), "stat");
    await("process " + child.pid() + " has stopped")
        .atMost(20, SECONDS)
        .until(() -> Files.readString(stat).matches("(?s).*\\) T .*"));
    ProcessIdentity identity = ProcessIdentity.of(child.toHandle());
    identity.destroy(false);
    assertThat(identity.awaitDeath(Duration.ofMillis(100))).as("ended though stopped").isFalse();
    identity.destroy(true);
    assertThat(identity.awaitDeath(Duration.ofSeconds(10))).isTrue();
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void endedProcessThatNobodyBuriesIsDead() throws Exception {
    // The shell starts a short process and becomes one that never asks what became of it.
    Process parent = new ProcessBuilder("sh", "-c", "sleep 0.3 & echo $!; exec sleep 300").start();
    try {
      long pid = Long.parseLong(parent.inputReader().readLine());
      ProcessIdentity identity = ProcessIdentity.of(ProcessHandle.of(pid).orElseThrow());
      await("process " + pid + " has ended").atMost(20, SECONDS).until(() -> !identity.isAlive());
      assertThat(ProcessHandle.of(pid)).as("it is still in the process table").isPresent();
    } finally {
      parent.destroyForcibly().waitFor();
    }
  }
}
