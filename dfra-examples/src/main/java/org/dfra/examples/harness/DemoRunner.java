package org.dfra.examples.harness;

import java.io.IOException;
import org.dfra.cli.log.LogbackSetup;
import org.dfra.core.log.LogLevelControl;
import org.dfra.module.LogLevel;
import org.dfra.report.progress.DemoAssertions;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.report.terminal.ConsoleMessages;

/**
 * Runs a demonstration, usually in its own environment: reports a failure with the step in which it
 * happened, prints a table of measurements at the end, and always cleans up.
 */
public final class DemoRunner {

  private DemoRunner() {}

  /** A demonstration in an environment. */
  public interface EnvironmentDemo {
    void on(DemoEnvironment environment) throws Exception;
  }

  /** A demonstration without an environment. */
  public interface StandaloneDemo {
    void play() throws Exception;
  }

  /**
   * Runs it.
   *
   * @return whether every step succeeded; missed targets are not failures here
   */
  public static boolean run(ProgressReporter progress, EnvironmentDemo play) {
    try (DemoEnvironment environment = new DemoEnvironment()) {
      Runtime.getRuntime().addShutdownHook(new Thread(() -> closeQuietly(environment), "demo-end"));
      boolean isWell =
          runStandalone(
              progress,
              () -> {
                play.on(environment);
                end(progress, environment);
              });
      if (!isWell) {
        environment.keepFolder();
        progress.say("The logs are in %s.", environment.folder());
      }
      return isWell;
    } catch (IOException e) {
      progress.say("The demonstration's processes or files could not be removed: %s", e);
      return false;
    }
  }

  /**
   * Runs a demonstration that cleans up its own processes.
   *
   * @return whether every step succeeded; missed targets are not failures here
   */
  public static boolean runStandalone(ProgressReporter progress, StandaloneDemo piece) {
    quietenLogs();
    try {
      piece.play();
      progress.table();
      return true;
    } catch (Exception e) { // reports any failure of the demonstration
      progress.freezeLive();
      progress.heading("FAILED while " + progress.step());
      progress.say("%s", e.toString());
      return false;
    }
  }

  /**
   * Limits the log to errors, unless the user has set a level: a demonstration reports its own
   * progress.
   */
  private static void quietenLogs() {
    if (System.getenv(LogbackSetup.LEVEL) == null) {
      LogLevelControl.service().set("org.dfra", LogLevel.ERROR);
      LogLevelControl.service().set("dfra", LogLevel.ERROR); // modules, if they run in this process
    }
  }

  private static void end(ProgressReporter progress, DemoEnvironment environment) throws Exception {
    progress.section("shutting down", "The end");
    environment.shutDown();
    DemoAssertions.require(
        environment.runningProcesses().isEmpty(),
        "processes " + environment.runningProcesses() + " still run");
    progress.say("All %d processes of this demonstration have ended.", environment.processCount());
  }

  private static void closeQuietly(DemoEnvironment environment) {
    try {
      environment.close();
    } catch (IOException e) {
      System.err.println(ConsoleMessages.prefixed(String.valueOf(e.getMessage())));
    }
  }

  /** A demonstration. */
  public interface Demo {

    /**
     * Runs it from beginning to end and cleans up.
     *
     * @return whether every step succeeded; failures have been reported
     */
    boolean run();
  }
}
