package org.dfra.river.phoenix;

import static java.util.concurrent.TimeUnit.SECONDS;
import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.FileInputStream;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.dfra.core.time.ScaledTime;
import org.dfra.river.fixture.ChildJvm;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** A process is distinguished from a later one with the same number. */
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
    assertThat(identity.awaitExit(Duration.ofMillis(50))).as("ended within 50 ms").isFalse();
  }

  @Test
  void aProcessIsFoundByItsNumber() throws Exception {
    assertThat(ProcessIdentity.find(child.pid())).contains(ProcessIdentity.of(child.toHandle()));
    child.destroyForcibly().waitFor();
    assertThat(ProcessIdentity.find(child.pid())).isEmpty();
  }

  @Test
  void anotherProcessWithTheSameNumberIsNotTheSameAndIsLeftAlone() {
    ProcessIdentity former = new ProcessIdentity(child.pid(), "tick 1 of boot before");
    assertThat(former.isAlive()).isFalse();
    former.kill();
    assertThat(former.awaitExit(Duration.ZERO)).isTrue();
    assertThat(child.isAlive()).as("the process that has the number now").isTrue();
  }

  @Test
  void killedProcessIsDeadAndItsDeathAwaited() {
    ProcessIdentity identity = ProcessIdentity.of(child.toHandle());
    identity.kill();
    assertThat(identity.awaitExit(Duration.ofSeconds(10))).isTrue();
    assertThat(identity.isAlive()).isFalse();
    identity.kill(); // of no consequence
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
    identity.terminate();
    assertThat(identity.awaitExit(Duration.ofMillis(100))).as("ended though stopped").isFalse();
    identity.kill();
    assertThat(identity.awaitExit(Duration.ofSeconds(10))).isTrue();
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

  /**
   * A process that may open no more files finds a living process alive and a dead one dead, ends
   * nobody by mistake, and can end it as soon as it may open files again. It knows its boot
   * throughout, also where it first hands on a time.
   */
  @Test
  @EnabledOnOs(OS.LINUX)
  void shortageOfDescriptorsKillsNobody() throws Exception {
    Process ended = new ProcessBuilder("true").start();
    ProcessIdentity dead = ProcessIdentity.of(ended.toHandle());
    assertThat(ended.waitFor(20, TimeUnit.SECONDS)).isTrue();
    assertThat(
            ChildJvm.run(
                List.of("sh", "-c", "ulimit -n 200; exec \"$@\"", "limit"),
                Starved.class,
                List.of(),
                Long.toString(child.pid()),
                Long.toString(dead.pid())))
        .contains(
            "alive when starved: true",
            "dead when starved: true",
            "alive after it was to be ended: true",
            "a new one: cannot be identified",
            "a search: cannot be found out",
            "a search for the dead: false",
            "ended when fed: true",
            "a time says its boot when starved: true",
            "a time says its boot when fed: true");
    assertThat(child.waitFor(20, TimeUnit.SECONDS)).isTrue();
  }

  /** Runs out of file descriptors, and says what it knows of the processes of its arguments. */
  static final class Starved {
    public static void main(String[] args) throws Exception {
      ProcessIdentity living =
          ProcessIdentity.of(ProcessHandle.of(Long.parseLong(args[0])).orElseThrow());
      ProcessIdentity dead = new ProcessIdentity(Long.parseLong(args[1]), living.start());
      boolean unused = living.isAlive() && dead.isAlive(); // loads what it needs
      ScaledTime time = new ScaledTime(4, Instant.EPOCH);
      new ProcessIdentity(living.pid(), "another").kill();
      List<String> messages = new ArrayList<>();
      List<FileInputStream> open = new ArrayList<>();
      try {
        while (true) {
          open.add(new FileInputStream("/dev/null"));
        }
      } catch (FileNotFoundException e) { // too many open files
        messages.add("a time says its boot when starved: " + time.toHostText().contains("(boot "));
        messages.add("alive when starved: " + living.isAlive());
        messages.add("dead when starved: " + !dead.isAlive());
        living.kill();
        messages.add("alive after it was to be ended: " + living.isAlive());
        try {
          ProcessIdentity found = ProcessIdentity.of(ProcessHandle.current());
          messages.add("a new one: " + found);
        } catch (UncheckedIOException unknown) {
          messages.add("a new one: cannot be identified");
        }
        try {
          messages.add("a search: " + ProcessIdentity.find(living.pid()));
        } catch (IOException unknown) {
          messages.add("a search: cannot be found out");
        }
        messages.add("a search for the dead: " + ProcessIdentity.find(dead.pid()).isPresent());
      }
      for (FileInputStream each : open) {
        each.close();
      }
      messages.add("a time says its boot when fed: " + time.toHostText().contains("(boot "));
      living.kill();
      messages.add("ended when fed: " + living.awaitExit(Duration.ofSeconds(20)));
      messages.forEach(System.out::println);
    }
  }
}
