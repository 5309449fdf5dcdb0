package org.dfra.benchmarks.scale;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dfra.benchmarks.task.TaskProcess;

/** A robot's or an observer's process. Used by one thread at a time. */
final class TeamProcess implements AutoCloseable {

  private static final Duration PATIENCE = Duration.ofMinutes(5);
  private static final List<String> OPTIONS = List.of("-Xmx96m");

  private final TaskProcess process;

  private TeamProcess(TaskProcess process) {
    this.process = process;
  }

  /**
   * Starts a robot; {@link #awaitLocator} waits for it.
   *
   * @param modules number of its modules
   * @param others locators that its modules join beside its own
   */
  static TeamProcess robot(String name, int modules, List<String> others) throws IOException {
    List<String> args = new ArrayList<>(List.of(name, Integer.toString(modules)));
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

  /** The locator of the robot's lookup service, when that lists all its modules. */
  String awaitLocator() throws IOException, InterruptedException {
    return answer("locator ");
  }

  private String answer(String prefix) throws IOException, InterruptedException {
    return process.awaitLine(prefix, PATIENCE).substring(prefix.length());
  }

  /** Begins to know a team; {@link #awaitComplete} waits until it does. */
  void watch(int modules, List<String> locators) throws IOException {
    process.write("watch " + modules + " " + String.join(" ", locators));
  }

  /** Seconds until it knew the whole team. */
  double awaitComplete() throws IOException, InterruptedException {
    return Long.parseLong(answer("complete ")) / 1e9;
  }

  /** Traffic and threads so far. */
  ProcessTraffic traffic() throws IOException, InterruptedException {
    process.write("traffic");
    return ProcessTraffic.parse(answer("traffic "));
  }

  /**
   * Pauses or resumes its first module.
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
