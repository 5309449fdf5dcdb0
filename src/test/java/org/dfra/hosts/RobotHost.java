package org.dfra.hosts;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.dfra.river.bootstrap.JvmCommand;
import org.dfra.testing.TalkingProcess;
import org.dfra.testing.TestHosts;

/** A host with a robot on it, brought up as a user does it, and a client beside it. */
final class RobotHost implements AutoCloseable {

  private static final long PATIENCE_SECONDS = 60;

  private final TestHosts hosts;
  private final int number;
  private final String robot;
  private final Path folder;
  private final TalkingProcess client;

  /**
   * Starts everything.
   *
   * @param number which of the hosts
   * @param team discovery group
   * @param folder an empty folder of this host alone
   */
  RobotHost(TestHosts hosts, int number, String team, Path folder)
      throws IOException, InterruptedException {
    this.hosts = hosts;
    this.number = number;
    this.robot = "atrv" + (number + 1);
    this.folder = Files.createDirectories(folder);
    List<String> command = new ArrayList<>(hosts.on(number));
    command.addAll(TalkingProcess.java(System.getProperty("java.class.path"), List.of()));
    command.addAll(List.of(HostClient.class.getName(), team));
    this.client = new TalkingProcess(command);
    String[] links = client.awaitLine().split(" ");
    String prefix = "DFRA_" + robot.toUpperCase(java.util.Locale.ROOT);
    dfra(
        Map.of(
            "DFRA_TEAM",
            team,
            prefix + "_GPS_FRONT_LINK",
            links[0],
            prefix + "_GPS_REAR_LINK",
            links[1]),
        "up",
        Path.of(System.getProperty("dfra.root"), "config/teams/field", robot + ".xml").toString(),
        "--registry-port=-1",
        "--state=" + folder.resolve("state"));
  }

  private void dfra(Map<String, String> environment, String... arguments)
      throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(hosts.on(number));
    command.add(JvmCommand.java());
    command.addAll(JvmCommand.options());
    command.add("-Ddfra.root=" + System.getProperty("dfra.root"));
    command.add("org.dfra.app.Main");
    command.addAll(List.of(arguments));
    Path log = folder.resolve("dfra.log");
    ProcessBuilder builder =
        new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(log.toFile());
    builder.environment().putAll(environment);
    Process process = builder.start();
    if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
      process.destroyForcibly();
      throw new AssertionError(robot + " is not up yet: " + Files.readString(log));
    }
    assertThat(process.exitValue()).as(Files.readString(log)).isZero();
  }

  /** The robot's name. */
  String robot() {
    return robot;
  }

  /** Modules that the client here sees, by path: identity and whether fresh. */
  Map<String, String> list() throws IOException, InterruptedException {
    String said = client.ask("list");
    return said.isBlank()
        ? Map.of()
        : Arrays.stream(said.split(" "))
            .map(each -> each.split("="))
            .collect(Collectors.toMap(each -> each[0], each -> each[1], (a, b) -> a, TreeMap::new));
  }

  /** What the client here says to a line. */
  String ask(String line) throws IOException, InterruptedException {
    return client.ask(line);
  }

  /** All that the client has logged. */
  String log() {
    return client.output();
  }

  @Override
  public void close() throws IOException, InterruptedException {
    client.close();
  }
}
