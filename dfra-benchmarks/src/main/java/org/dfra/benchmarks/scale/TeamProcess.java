package org.dfra.benchmarks.scale;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dfra.benchmarks.task.TaskProcess;

/** The process of robots, or of an observer. Used by one thread at a time. */
final class TeamProcess implements AutoCloseable {

  private static final Duration PATIENCE = Duration.ofMinutes(20);
  private static final List<String> OPTIONS = List.of("-Xmx1g", "-Xmn64m");

  private final TaskProcess process;

  private TeamProcess(TaskProcess process) {
    this.process = process;
  }

  /**
   * Starts robots; {@link #awaitLocators} waits for them.
   *
   * @param modules number of modules of each
   * @param others locators that their modules join beside their own
   */
  static TeamProcess robots(List<String> names, int modules, List<String> others)
      throws IOException {
    List<String> args = new ArrayList<>(List.of(String.join(",", names), "" + modules));
    args.addAll(others);
    return new TeamProcess(
        TaskProcess.start(List.of(), OPTIONS, RobotTask.class, args.toArray(String[]::new)));
  }

  /** Starts an observer. */
  static TeamProcess observer() throws IOException, InterruptedException {
    TeamProcess observer =
        new TeamProcess(TaskProcess.start(List.of(), OPTIONS, ObserverTask.class));
    String unused = observer.process.awaitLine("ready", PATIENCE);
    return observer;
  }

  /** The locators of its robots' lookup services, when these list all modules. */
  List<String> awaitLocators() throws IOException, InterruptedException {
    return List.of(answer("locators ").split(" ", -1));
  }

  private String answer(String prefix) throws IOException, InterruptedException {
    return process.awaitLine(prefix, PATIENCE).substring(prefix.length());
  }

  /** Begins to know a team; {@link #awaitComplete} waits until each of its robots does. */
  void watch(int modules, List<String> locators) throws IOException {
    process.write("watch " + modules + " " + String.join(" ", locators));
  }

  /** Seconds until the last of its robots knew the whole team. */
  double awaitComplete() throws IOException, InterruptedException {
    return Long.parseLong(answer("complete ")) / 1e9;
  }

  /** Traffic and threads so far. */
  ProcessTraffic traffic() throws IOException, InterruptedException {
    process.write("traffic");
    return ProcessTraffic.parse(answer("traffic "));
  }

  /**
   * Pauses or resumes the first module of its first robot.
   *
   * @return nanoseconds of the system before that
   */
  long toggle() throws IOException, InterruptedException {
    process.write("toggle");
    return Long.parseLong(answer("toggled "));
  }

  /** Nanoseconds of the system when it saw the next change. */
  long awaitChange() throws IOException, InterruptedException {
    return Long.parseLong(answer("saw "));
  }

  long pid() {
    return process.pid();
  }

  /** Kills it. */
  @Override
  public void close() throws InterruptedException {
    process.close();
  }
}
