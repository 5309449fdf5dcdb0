package org.dfra.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.dfra.core.host.FreePorts;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.phoenix.GroupStatus;
import org.dfra.testing.InteractiveProcess;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * A robot outlives the script that has brought it up: Ctrl-C there, and, in {@code dfra.full}, the
 * end of its terminal.
 */
@Timeout(300)
class DetachedCommandIT {

  /** Tests that nohup runs, or a shell beside itself, inherit that signals are ignored. */
  private static final List<String> UNTOUCHED = List.of("env", "--default-signal=INT,HUP");

  private static final Duration PATIENCE = Duration.ofSeconds(60);
  private static final String UP = "the robot is up";

  @TempDir Path folder;

  /** A script, in a process group of its own as a shell starts it, that calls up and stays. */
  private Process script(int port) throws IOException {
    Path xml =
        Files.writeString(
            folder.resolve("robot.xml"),
            """
            <robot xmlns="urn:dfra:robot:1" name="eta" host="127.0.0.1">
              <group name="lookup"><registrar port="%d" class-server-port="off"/></group>
            </robot>
            """
                .formatted(FreePorts.allocate()));
    List<String> command = new ArrayList<>(UNTOUCHED);
    command.addAll(List.of("setsid", "/bin/sh", "-c"));
    command.add("\"$@\" && echo '" + UP + "' && while :; do sleep 1; done");
    command.add("sh");
    command.addAll(InteractiveProcess.java(System.getProperty("java.class.path"), List.of()));
    command.addAll(List.of("org.dfra.cli.Main", "up", xml.toString(), "--port=" + port));
    command.addAll(List.of("--registry-port=-1", "--state=" + folder.resolve("state")));
    return new ProcessBuilder(command).redirectErrorStream(true).start();
  }

  private static Stream<String> signals() {
    return Boolean.getBoolean("dfra.full") ? Stream.of("INT", "HUP") : Stream.of("INT");
  }

  @ParameterizedTest
  @MethodSource("signals")
  void staysUpWhenTheScriptsProcessGroupIsSignalled(String signal) throws Exception {
    assumeTrue(new ProcessBuilder("which", "setsid").start().waitFor() == 0, "no setsid here");
    int port = FreePorts.allocate();
    PhoenixProcess phoenix = new PhoenixProcess("127.0.0.1", port, -1, folder.resolve("state"));
    Process script = script(port);
    try {
      BufferedReader out = script.inputReader();
      List<String> messages = new ArrayList<>();
      for (String line; !messages.contains(UP) && (line = out.readLine()) != null; ) {
        messages.add(line);
      }
      assertThat(messages).contains(UP);
      GroupStatus before = phoenix.admin().groupStatus().get(0);
      long pid = phoenix.pid().orElseThrow();

      Process kill =
          new ProcessBuilder("/bin/sh", "-c", "kill -" + signal + " -" + script.pid()).start();
      assertThat(kill.waitFor()).isZero();
      assertThat(script.waitFor(PATIENCE.toSeconds(), TimeUnit.SECONDS)).as("it ends").isTrue();

      ProcessHandle daemon = ProcessHandle.of(pid).orElseThrow();
      assertThat(daemon.onExit().completeOnTimeout(daemon, 1, TimeUnit.SECONDS).get().isAlive())
          .as("phoenix lives on")
          .isTrue();
      GroupStatus after = phoenix.admin().groupStatus().get(0);
      assertThat(after.pid()).isEqualTo(before.pid());
      assertThat(after.incarnation()).isEqualTo(before.incarnation());
    } finally {
      script.descendants().forEach(ProcessHandle::destroyForcibly);
      script.destroyForcibly();
      if (phoenix.isResponding()) {
        phoenix.shutdown(PATIENCE);
      }
      await().atMost(PATIENCE).until(() -> phoenix.pid().isEmpty());
    }
  }
}
