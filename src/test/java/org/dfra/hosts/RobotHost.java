package org.dfra.hosts;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.dfra.river.bootstrap.JvmCommand;
import org.dfra.testing.InteractiveProcess;
import org.dfra.testing.NetworkNamespaceHosts;

/** A host with a robot on it, brought up as a user does it, and a client beside it. */
final class RobotHost implements AutoCloseable {

  private static final long PATIENCE_SECONDS = 240; // eight virtual machines start

  private static final int ATTEMPTS = 4;
  private static final String LOG = "dfra.log";

  private final NetworkNamespaceHosts hosts;
  private final int number;
  private final Map<String, String> settings = new TreeMap<>(); // of the environment
  private final String robot;
  private final Path folder;
  private final InteractiveProcess client;

  /**
   * Starts everything.
   *
   * @param number which of the hosts
   * @param team discovery group
   * @param xml the robot's description
   * @param folder an empty folder of this host alone
   * @param time by what time the robot lives: {@code real} or as {@code DFRA_TIME} is written
   * @param client main class of the client and its further arguments; the first is the team, and
   *     the first that it says is which devices have which links, as {@code DEVICE=link ...}
   */
  RobotHost(
      NetworkNamespaceHosts hosts,
      int number,
      String team,
      Path xml,
      Path folder,
      String time,
      List<String> client)
      throws IOException, InterruptedException {
    this.hosts = hosts;
    this.number = number;
    this.robot = "atrv" + (number + 1);
    this.folder = Files.createDirectories(folder);
    List<String> command = new ArrayList<>(hosts.commandPrefix(number));
    command.addAll(InteractiveProcess.java(System.getProperty("java.class.path"), List.of()));
    command.addAll(List.of(client.get(0), team));
    command.addAll(client.subList(1, client.size()));
    this.client = new InteractiveProcess(command);
    settings.put("DFRA_TEAM", team);
    settings.put("DFRA_TIME", time);
    for (String device : this.client.awaitLine().split(" ")) {
      String[] parts = device.split("=");
      settings.put("DFRA_" + robot.toUpperCase(Locale.ROOT) + "_" + parts[0] + "_LINK", parts[1]);
    }
    bringUp(xml.toString());
  }

  /** A robot's description as it is shipped. */
  static Path shipped(String team, String robot) {
    return Path.of(System.getProperty("dfra.root"), "config/teams", team, robot + ".xml");
  }

  /** On a busy machine a registrar may not answer in time: then all is ended, and begun again. */
  private void bringUp(String xml) throws IOException, InterruptedException {
    String state = "--state=" + folder.resolve("state");
    for (int attempt = 1; dfra("up", xml, "--open", "--registry-port=-1", state) != 0; attempt++) {
      String printed = Files.readString(folder.resolve(LOG));
      assertThat(attempt).as(printed).isLessThan(ATTEMPTS);
      assertThat(printed).contains("got no answer within");
      int unused = dfra("down", state);
    }
  }

  /** Runs a command of {@code ./dfra} on this host, as its user does, and returns its exit code. */
  private int dfra(String... arguments) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(hosts.commandPrefix(number));
    command.add(JvmCommand.java());
    command.addAll(JvmCommand.options());
    command.add("-Ddfra.root=" + System.getProperty("dfra.root"));
    command.add("org.dfra.cli.Main");
    command.addAll(List.of(arguments));
    Path log = folder.resolve(LOG);
    ProcessBuilder builder =
        new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(log.toFile());
    builder.environment().putAll(settings);
    Process process = builder.start();
    if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
      process.destroyForcibly();
      throw new AssertionError(
          String.join(" ", arguments)
              + " does not end on the host of "
              + robot
              + ": "
              + Files.readString(log));
    }
    return process.exitValue();
  }

  /** The robot's name. */
  String robot() {
    return robot;
  }

  /** Modules that the client here sees, by path: identity and whether fresh. */
  Map<String, String> list() throws IOException, InterruptedException {
    String printed = client.request("list");
    return printed.isBlank()
        ? Map.of()
        : Arrays.stream(printed.split(" "))
            .map(each -> each.split("="))
            .collect(Collectors.toMap(each -> each[0], each -> each[1], (a, b) -> a, TreeMap::new));
  }

  /** What the client here says to a line. */
  String ask(String line) throws IOException, InterruptedException {
    return client.request(line);
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
