package org.dfra.examples.harness;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.dfra.core.host.FreePorts;
import org.dfra.core.host.PrivateFiles;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.phoenix.GroupStatus;
import org.jspecify.annotations.Nullable;

/**
 * A simulated host of a demonstration on this computer: a phoenix and its service groups. It shares
 * neither a process nor a file with the other hosts.
 */
public final class DemoHost {

  private static final Duration PATIENCE = DemoEnvironment.PATIENCE;

  private final DemoEnvironment environment;
  private final PhoenixProcess phoenix;
  private @Nullable ProcessHandle running; // the phoenix that was started last
  private final Set<ProcessHandle> groupProcesses = ConcurrentHashMap.newKeySet();

  /**
   * @param environment records the processes
   * @param folder the host's own folder
   */
  public DemoHost(DemoEnvironment environment, Path folder) throws IOException {
    this.environment = environment;
    PrivateFiles.makeFolder(folder); // before other files in it create it
    this.phoenix = new PhoenixProcess(DemoEnvironment.ADDRESS, FreePorts.allocate(), -1, folder);
  }

  public PhoenixProcess phoenix() {
    return phoenix;
  }

  /** Starts phoenix in a process of its own and waits until it answers. */
  public ProcessHandle startPhoenix() throws IOException {
    ProcessHandle process = phoenix.start(PATIENCE).toHandle();
    environment.remember(process);
    running = process;
    return process;
  }

  /** Kills phoenix with SIGKILL and waits until it has exited. */
  public void killPhoenix() throws IOException, InterruptedException {
    if (running == null) {
      throw new IllegalStateException("phoenix was not started");
    }
    kill(running.pid());
    DemoEnvironment.awaitEnd(running);
  }

  /** Sends SIGKILL to a process and does not wait. */
  public void kill(long pid) throws IOException, InterruptedException {
    environment.signal("KILL", pid);
  }

  /** The status of the group whose name has this suffix. */
  public GroupStatus group(String ending) throws IOException {
    return groups().stream()
        .filter(group -> group.name().endsWith(ending))
        .findFirst()
        .orElseThrow(() -> new IOException("phoenix has no group " + ending));
  }

  /** The status of each group; records their processes for cleaning up. */
  public List<GroupStatus> groups() throws IOException {
    List<GroupStatus> groups = phoenix.admin().groupStatus();
    groups.stream()
        .filter(group -> group.pid() > 0)
        .flatMap(group -> ProcessHandle.of(group.pid()).stream())
        .forEach(
            process -> {
              groupProcesses.add(process);
              environment.remember(process);
            });
    return groups;
  }

  /** Ends phoenix and its groups, as an operator would; if phoenix is dead, its groups alone. */
  public void shutDown() throws IOException {
    if (running != null && !running.isAlive()) {
      groupProcesses.forEach(ProcessHandle::destroyForcibly);
      return;
    }
    List<GroupStatus> unused = groups();
    phoenix.shutdown(PATIENCE);
  }

  /** Records the processes of the groups, while phoenix can still report them. */
  public void rememberGroups() {
    try {
      List<GroupStatus> unused = groups();
    } catch (IOException e) {
      // Phoenix is down already: its processes were recorded before.
      assert !phoenix.isResponding();
    }
  }
}
