package org.dfra.app.demo;

import java.io.BufferedReader;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.dfra.river.bootstrap.JvmCommand;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.phoenix.GroupStatus;
import org.dfra.sim.device.ReceiverEmulatorMain;
import org.jspecify.annotations.Nullable;

/**
 * What a demonstration stands on: a temporary folder, an emulated receiver, phoenix, and the
 * certainty that all of it is gone afterwards.
 */
final class Stage implements AutoCloseable {

  static final String HOST = "127.0.0.1";

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  private final Path folder;
  private final PhoenixProcess phoenix;
  private final List<ProcessHandle> started = new ArrayList<>();
  private final List<ProcessHandle> receivers = new ArrayList<>();
  private @Nullable ProcessHandle lastPhoenix;
  private boolean keepFolder;
  private boolean closed; // guarded by this

  Stage() throws IOException {
    folder = Files.createTempDirectory("dfra-demo-");
    phoenix = new PhoenixProcess(HOST, freePort(), -1, folder.resolve("phoenix"));
  }

  PhoenixProcess phoenix() {
    return phoenix;
  }

  /** The folder with every log. */
  Path folder() {
    return folder;
  }

  /** Keeps the folder, so that somebody can read the logs. */
  void keepFolder() {
    keepFolder = true;
  }

  /** Starts an emulated M12+ in a process of its own; returns its link. */
  String startReceiver() throws IOException {
    Path receiverLog = folder.resolve("receiver-" + (receivers.size() + 1) + ".log");
    List<String> command = new ArrayList<>(List.of(JvmCommand.java()));
    command.addAll(JvmCommand.options());
    command.addAll(
        List.of(
            ReceiverEmulatorMain.class.getName(),
            "--latitude=27.9506",
            "--longitude=-82.4572",
            "--height=14.5"));
    Process process = new ProcessBuilder(command).redirectError(receiverLog.toFile()).start();
    started.add(process.toHandle());
    receivers.add(process.toHandle());
    BufferedReader reader = process.inputReader(StandardCharsets.UTF_8);
    String line = reader.readLine();
    String ready = "listening on ";
    if (line == null || !line.startsWith(ready)) {
      throw new IOException("the emulated receiver did not start; see " + receiverLog);
    }
    return line.substring(ready.length());
  }

  /** Starts phoenix in a process of its own and waits until it answers. */
  ProcessHandle startPhoenix() throws IOException {
    ProcessHandle process = phoenix.start(PATIENCE).toHandle();
    started.add(process);
    lastPhoenix = process;
    return process;
  }

  private ProcessHandle lastPhoenix() {
    return Objects.requireNonNull(lastPhoenix, "phoenix was not started");
  }

  /** The status of the group whose name ends so. */
  GroupStatus group(String ending) throws IOException {
    return groups().stream()
        .filter(group -> group.name().endsWith(ending))
        .findFirst()
        .orElseThrow(() -> new IOException("phoenix knows no group " + ending));
  }

  /** Every group's status; their processes are remembered for the end. */
  List<GroupStatus> groups() throws IOException {
    List<GroupStatus> groups = phoenix.admin().groupStatus();
    groups.stream()
        .filter(group -> group.pid() > 0)
        .flatMap(group -> ProcessHandle.of(group.pid()).stream())
        .filter(process -> !started.contains(process))
        .forEach(started::add);
    return groups;
  }

  /** Kills phoenix with -9 and waits until it is gone. */
  void killPhoenix() throws IOException, InterruptedException {
    signal("KILL", lastPhoenix().pid());
    awaitEnd(lastPhoenix());
  }

  /** Sends a signal, as an operator would. */
  void signal(String name, long pid) throws IOException, InterruptedException {
    if (new ProcessBuilder("kill", "-" + name, Long.toString(pid)).start().waitFor() != 0) {
      throw new IOException("process " + pid + " could not be sent " + name);
    }
  }

  private static void awaitEnd(ProcessHandle process) throws IOException, InterruptedException {
    try {
      process.onExit().get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    } catch (java.util.concurrent.ExecutionException | java.util.concurrent.TimeoutException e) {
      throw new IOException("process " + process.pid() + " does not end", e);
    }
  }

  /** Takes everything down as an operator would; the receivers are switched off last. */
  void shutDown() throws IOException, InterruptedException {
    groups();
    phoenix.shutdown(PATIENCE);
    receivers.forEach(ProcessHandle::destroy);
    for (ProcessHandle process : started) {
      awaitEnd(process);
    }
  }

  /** Processes of this stage that still run. */
  List<Long> left() {
    return started.stream().filter(ProcessHandle::isAlive).map(ProcessHandle::pid).toList();
  }

  /** How many processes this stage has seen. */
  int seen() {
    return started.size();
  }

  /** Ends whatever still runs and removes the folder, unless it is kept. Idempotent. */
  @Override
  public synchronized void close() throws IOException {
    if (closed) {
      return;
    }
    closed = true;
    try {
      groups();
    } catch (IOException e) {
      // Phoenix is down already: what it ran is remembered from before.
      assert !phoenix.answers();
    }
    started.forEach(ProcessHandle::destroyForcibly);
    if (!keepFolder) {
      try (Stream<Path> paths = Files.walk(folder)) {
        for (Path path : paths.sorted(Comparator.reverseOrder()).toList()) {
          Files.deleteIfExists(path);
        }
      }
    }
  }

  /** A TCP port that nobody listens on now. */
  static int freePort() throws IOException {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getByName(HOST))) {
      return socket.getLocalPort();
    }
  }
}
