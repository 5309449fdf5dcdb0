package org.dfra.examples.harness;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
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
import org.dfra.sim.device.gps.ReceiverEmulatorMain;

/**
 * The environment of a demonstration: a temporary folder, emulated receivers and hosts. All of them
 * are removed at the end.
 */
public final class DemoEnvironment implements AutoCloseable {

  /** The IP address of everything here. */
  public static final String ADDRESS = "127.0.0.1";

  /**
   * The longest wait for what must happen on every computer, however slow. How fast it has to
   * happen is the bound of a figure.
   */
  public static final Duration PATIENCE = Duration.ofSeconds(120);

  private static final String READY = "listening on ";

  private final Path folder;
  private final List<DemoHost> hosts = new CopyOnWriteArrayList<>();
  private final List<ProcessHandle> started = new CopyOnWriteArrayList<>();
  private final List<Process> devices = new CopyOnWriteArrayList<>();
  private volatile boolean keepFolder;

  @GuardedBy("this")
  private boolean closed;

  public DemoEnvironment() throws IOException {
    folder = Files.createTempDirectory("dfra-demo-");
  }

  /** The folder with every log. */
  public Path folder() {
    return folder;
  }

  /** Keeps the folder, so that the user can read the logs. */
  public void keepFolder() {
    keepFolder = true;
  }

  /**
   * Adds a host, on which nothing runs yet.
   *
   * @param name of its folder
   */
  public DemoHost host(String name) throws IOException {
    DemoHost host = new DemoHost(this, folder.resolve(name));
    hosts.add(host);
    return host;
  }

  /** Ends this process with the environment. */
  public synchronized void remember(ProcessHandle process) {
    if (!started.contains(process)) {
      started.add(process);
    }
  }

  /**
   * Starts emulated M12+ receivers, each in a separate process.
   *
   * @return their links, in the same order
   */
  public List<String> startReceivers(List<GeoPosition> positions) throws IOException {
    List<Process> begun = new ArrayList<>();
    for (GeoPosition position : positions) { // in parallel: a JVM starts slowly
      begun.add(startReceiver(position));
    }
    List<String> links = new ArrayList<>();
    for (Process each : begun) {
      String line = each.inputReader(StandardCharsets.UTF_8).readLine();
      if (line == null || !line.startsWith(READY)) {
        throw new IOException("an emulated receiver did not start; its log is in " + folder);
      }
      links.add(line.substring(READY.length()));
    }
    return links;
  }

  private Process startReceiver(GeoPosition position) throws IOException {
    return startJvm(
        "receiver-" + (devices.size() + 1),
        List.of(
            ReceiverEmulatorMain.class.getName(),
            "--latitude=" + position.latitude(),
            "--longitude=" + position.longitude(),
            "--height=" + position.height()));
  }

  /**
   * Starts a JVM that emulates devices: it ends last.
   *
   * @param name of its log, which contains its standard error
   * @param arguments the main class and its arguments
   */
  public Process startJvm(String name, List<String> arguments) throws IOException {
    List<String> command = new ArrayList<>(List.of(JvmCommand.java()));
    command.addAll(JvmCommand.options());
    command.add("-Ddfra.root=" + System.getProperty("dfra.root", ""));
    command.addAll(arguments);
    Process process =
        new ProcessBuilder(command).redirectError(folder.resolve(name + ".log").toFile()).start();
    remember(process.toHandle());
    devices.add(process);
    return process;
  }

  /** Sends a signal, as an operator would. */
  public void signal(String name, long pid) throws IOException, InterruptedException {
    if (new ProcessBuilder("kill", "-" + name, Long.toString(pid)).start().waitFor() != 0) {
      throw new IOException("process " + pid + " could not be sent " + name);
    }
  }

  /** Waits until a process has exited. */
  public static void awaitEnd(ProcessHandle process) throws IOException, InterruptedException {
    try {
      process.onExit().get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    } catch (ExecutionException | TimeoutException e) {
      throw new IOException("process " + process.pid() + " does not end", e);
    }
  }

  /** Shuts everything down as an operator would; the devices end last. */
  public void shutDown() throws IOException, InterruptedException {
    for (DemoHost host : hosts) {
      host.shutDown();
    }
    devices.forEach(Process::destroy);
    for (ProcessHandle process : started) {
      awaitEnd(process);
    }
  }

  /** Processes of this environment that still run. */
  public List<Long> runningProcesses() {
    return started.stream().filter(ProcessHandle::isAlive).map(ProcessHandle::pid).toList();
  }

  /** Number of processes that this environment has had. */
  public int processCount() {
    return started.size();
  }

  /** Ends all running processes and removes the folder, unless it is kept. Idempotent. */
  @Override
  public synchronized void close() throws IOException {
    if (closed) {
      return;
    }
    closed = true;
    hosts.forEach(DemoHost::rememberGroups);
    started.forEach(ProcessHandle::destroyForcibly);
    if (!keepFolder) {
      try (Stream<Path> paths = Files.walk(folder)) {
        for (Path path : paths.sorted(Comparator.reverseOrder()).toList()) {
          Files.deleteIfExists(path);
        }
      }
    }
  }
}
