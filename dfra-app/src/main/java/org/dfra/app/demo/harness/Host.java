package org.dfra.app.demo.harness;

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
 * One of the computers of a demonstration, which all are this one: a phoenix and the service groups
 * under it. It shares neither a process nor a file with the others.
 */
public final class Host {

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  private final DemoEnvironment stage;
  private final PhoenixProcess phoenix;
  private @Nullable ProcessHandle running; // the phoenix that was started last
  private final Set<ProcessHandle> groupProcesses = ConcurrentHashMap.newKeySet();

  /**
   * @param stage remembers the processes
   * @param folder the host's own
   */
  public Host(DemoEnvironment stage, Path folder) throws IOException {
    this.stage = stage;
    PrivateFiles.makeFolder(folder); // before anything else that is kept in it makes it
    this.phoenix = new PhoenixProcess(DemoEnvironment.ADDRESS, FreePorts.allocate(), -1, folder);
  }

  public PhoenixProcess phoenix() {
    return phoenix;
  }

  /** Starts phoenix in a process of its own and waits until it answers. */
  public ProcessHandle startPhoenix() throws IOException {
    ProcessHandle process = phoenix.start(PATIENCE).toHandle();
    stage.remember(process);
    running = process;
    return process;
  }

  /** Kills phoenix with -9 and waits until it is gone. */
  public void killPhoenix() throws IOException, InterruptedException {
    if (running == null) {
      throw new IllegalStateException("phoenix was not started");
    }
    kill(running.pid());
    DemoEnvironment.awaitEnd(running);
  }

  /** Kills a process with -9, and does not wait. */
  public void kill(long pid) throws IOException, InterruptedException {
    stage.signal("KILL", pid);
  }

  /** The status of the group whose name ends so. */
  public GroupStatus group(String ending) throws IOException {
    return groups().stream()
        .filter(group -> group.name().endsWith(ending))
        .findFirst()
        .orElseThrow(() -> new IOException("phoenix knows no group " + ending));
  }

  /** Every group's status; their processes are remembered for the end. */
  public List<GroupStatus> groups() throws IOException {
    List<GroupStatus> groups = phoenix.admin().groupStatus();
    groups.stream()
        .filter(group -> group.pid() > 0)
        .flatMap(group -> ProcessHandle.of(group.pid()).stream())
        .forEach(
            process -> {
              groupProcesses.add(process);
              stage.remember(process);
            });
    return groups;
  }

  /** Ends phoenix and its groups, as an operator would; where phoenix is dead, its groups alone. */
  public void shutDown() throws IOException {
    if (running != null && !running.isAlive()) {
      groupProcesses.forEach(ProcessHandle::destroyForcibly);
      return;
    }
    List<GroupStatus> unused = groups();
    phoenix.shutdown(PATIENCE);
  }

  /** Remembers the processes of the groups, where phoenix can still tell them. */
  public void rememberGroups() {
    try {
      List<GroupStatus> unused = groups();
    } catch (IOException e) {
      // Phoenix is down already: what it ran is remembered from before.
      assert !phoenix.isResponding();
    }
  }
}
