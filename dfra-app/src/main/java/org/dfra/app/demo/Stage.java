package org.dfra.app.demo;

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
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;
import org.dfra.geometry.GeoPosition;
import org.dfra.river.bootstrap.JvmCommand;
import org.dfra.sim.device.ReceiverEmulatorMain;

/**
 * What a demonstration stands on: a temporary folder, emulated receivers, hosts, and the certainty
 * that all of it is gone afterwards.
 */
final class Stage implements AutoCloseable {

  /** The address of everything here. */
  static final String ADDRESS = "127.0.0.1";

  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final String READY = "listening on ";

  private final Path folder;
  private final List<Host> hosts = new CopyOnWriteArrayList<>();
  private final List<ProcessHandle> started = new CopyOnWriteArrayList<>();
  private final List<Process> receivers = new CopyOnWriteArrayList<>();
  private volatile boolean keepFolder;
  private boolean closed; // guarded by this

  Stage() throws IOException {
    folder = Files.createTempDirectory("dfra-demo-");
  }

  /** The folder with every log. */
  Path folder() {
    return folder;
  }

  /** Keeps the folder, so that somebody can read the logs. */
  void keepFolder() {
    keepFolder = true;
  }

  /**
   * A further computer, on which nothing runs yet.
   *
   * @param name of its folder
   */
  Host host(String name) throws IOException {
    Host host = new Host(this, folder.resolve(name));
    hosts.add(host);
    return host;
  }

  /** Has a process ended with the stage. */
  synchronized void remember(ProcessHandle process) {
    if (!started.contains(process)) {
      started.add(process);
    }
  }

  /**
   * Starts emulated M12+ receivers, each in a process of its own.
   *
   * @return their links, in the same order
   */
  List<String> startReceivers(List<GeoPosition> positions) throws IOException {
    List<Process> begun = new ArrayList<>();
    for (GeoPosition position : positions) { // all at once: a JVM takes its time
      begun.add(startReceiver(position));
    }
    List<String> links = new ArrayList<>();
    for (Process each : begun) {
      String line = each.inputReader(StandardCharsets.UTF_8).readLine();
      if (line == null || !line.startsWith(READY)) {
        throw new IOException("an emulated receiver did not start; see its log in " + folder);
      }
      links.add(line.substring(READY.length()));
    }
    return links;
  }

  private Process startReceiver(GeoPosition position) throws IOException {
    Path receiverLog = folder.resolve("receiver-" + (receivers.size() + 1) + ".log");
    List<String> command = new ArrayList<>(List.of(JvmCommand.java()));
    command.addAll(JvmCommand.options());
    command.addAll(
        List.of(
            ReceiverEmulatorMain.class.getName(),
            "--latitude=" + position.latitude(),
            "--longitude=" + position.longitude(),
            "--height=" + position.height()));
    Process process = new ProcessBuilder(command).redirectError(receiverLog.toFile()).start();
    remember(process.toHandle());
    receivers.add(process);
    return process;
  }

  /** Sends a signal, as an operator would. */
  void signal(String name, long pid) throws IOException, InterruptedException {
    if (new ProcessBuilder("kill", "-" + name, Long.toString(pid)).start().waitFor() != 0) {
      throw new IOException("process " + pid + " could not be sent " + name);
    }
  }

  /** Waits until a process is gone. */
  static void awaitEnd(ProcessHandle process) throws IOException, InterruptedException {
    try {
      process.onExit().get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    } catch (ExecutionException | TimeoutException e) {
      throw new IOException("process " + process.pid() + " does not end", e);
    }
  }

  /** Takes everything down as an operator would; the receivers are switched off last. */
  void shutDown() throws IOException, InterruptedException {
    for (Host host : hosts) {
      host.shutDown();
    }
    receivers.forEach(Process::destroy);
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
    hosts.forEach(Host::rememberGroups);
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
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getByName(ADDRESS))) {
      return socket.getLocalPort();
    }
  }
}
