package org.dfra.river.bootstrap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** What is started in a session of its own outlives signals to its starter's process group. */
@Timeout(60)
class DetachedCommandTest {

  private static final Duration PATIENCE = Duration.ofSeconds(20);

  @TempDir Path folder;

  /** Starts a sleeper as phoenix is started, and gives what was asked of its shell meanwhile. */
  private Process sleeper(List<String> prefix) throws Exception {
    List<String> command = new ArrayList<>(prefix);
    command.addAll(List.of("/bin/sh", "-c", "echo ready; exec sleep 100"));
    Process process = new ProcessBuilder(command).start();
    BufferedReader out = process.inputReader();
    assertThat(out.readLine()).isEqualTo("ready");
    return process;
  }

  private static void signal(String signal, long pid) throws Exception {
    Process kill = new ProcessBuilder("/bin/sh", "-c", "kill -" + signal + " " + pid).start();
    assertThat(kill.waitFor()).isZero();
  }

  private static long session(long pid) throws Exception {
    String stat = Files.readString(Path.of("/proc", Long.toString(pid), "stat"));
    return Long.parseLong(stat.substring(stat.lastIndexOf(')') + 2).split(" ")[3]);
  }

  @Test
  void isASessionOfItsOwnWhereSetsidIs() throws Exception {
    List<String> prefix = DetachedCommand.prefix(System.getenv("PATH"));
    assumeTrue(prefix.get(0).endsWith("/setsid"), "no program setsid here");
    assumeTrue(Files.exists(Path.of("/proc/self/stat")), "no /proc here");
    Process process = sleeper(prefix);
    try {
      assertThat(session(process.pid()))
          .as("its session, with the process number that Java knows")
          .isEqualTo(process.pid())
          .isNotEqualTo(session(ProcessHandle.current().pid()));
    } finally {
      process.destroyForcibly();
    }
  }

  @Test
  void ignoresInterruptAndHangUpWhereNoSetsidIs() throws Exception {
    Process process = sleeper(DetachedCommand.prefix(folder.toString()));
    try {
      signal("INT", process.pid());
      signal("HUP", process.pid());
      assertThat(process.waitFor(300, TimeUnit.MILLISECONDS)).as("it has ended").isFalse();
      signal("TERM", process.pid());
      await().atMost(PATIENCE).until(() -> !process.isAlive());
    } finally {
      process.destroyForcibly();
    }
  }

  @Test
  void doesWithoutAPath() {
    assertThat(DetachedCommand.prefix(null)).startsWith("/bin/sh");
    assertThat(DetachedCommand.prefix("")).startsWith("/bin/sh");
  }
}
