package org.dfra.app.demo;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.phoenix.GroupStatus;
import org.jspecify.annotations.Nullable;

/**
 * One of the computers of a demonstration, which all are this one: a phoenix and the service groups
 * under it. It shares neither a process nor a file with the others.
 */
final class Host {

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  private final Stage stage;
  private final PhoenixProcess phoenix;
  private @Nullable ProcessHandle running; // the phoenix that was started last

  /**
   * @param stage remembers the processes
   * @param folder the host's own
   */
  Host(Stage stage, Path folder) throws IOException {
    this.stage = stage;
    this.phoenix = new PhoenixProcess(Stage.ADDRESS, Stage.freePort(), -1, folder);
  }

  PhoenixProcess phoenix() {
    return phoenix;
  }

  /** Starts phoenix in a process of its own and waits until it answers. */
  ProcessHandle startPhoenix() throws IOException {
    ProcessHandle process = phoenix.start(PATIENCE).toHandle();
    stage.remember(process);
    running = process;
    return process;
  }

  /** Kills phoenix with -9 and waits until it is gone. */
  void killPhoenix() throws IOException, InterruptedException {
    if (running == null) {
      throw new IllegalStateException("phoenix was not started");
    }
    stage.signal("KILL", running.pid());
    Stage.awaitEnd(running);
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
        .forEach(stage::remember);
    return groups;
  }

  /** Ends phoenix and its groups, as an operator would. */
  void shutDown() throws IOException {
    List<GroupStatus> unused = groups();
    phoenix.shutdown(PATIENCE);
  }

  /** Remembers the processes of the groups, where phoenix can still tell them. */
  void rememberGroups() {
    try {
      List<GroupStatus> unused = groups();
    } catch (IOException e) {
      // Phoenix is down already: what it ran is remembered from before.
      assert !phoenix.answers();
    }
  }
}
