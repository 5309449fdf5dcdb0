package org.dfra.app.demo.harness;

import java.io.IOException;
import org.dfra.app.log.LogbackSetup;
import org.dfra.app.terminal.ConsoleMessages;
import org.dfra.core.log.LogLevelControl;
import org.dfra.module.LogLevel;

/**
 * Runs a demonstration, usually in its own environment: reports a failure with the step in which it
 * happened, prints a table of measurements at the end, and always cleans up.
 */
public final class DemoRunner {

  private DemoRunner() {}

  /** A demonstration in an environment. */
  public interface EnvironmentDemo {
    void on(DemoEnvironment stage) throws Exception;
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
    try (DemoEnvironment stage = new DemoEnvironment()) {
      Runtime.getRuntime().addShutdownHook(new Thread(() -> closeQuietly(stage), "demo-end"));
      boolean isWell =
          runStandalone(
              progress,
              () -> {
                play.on(stage);
                end(progress, stage);
              });
      if (!isWell) {
        stage.keepFolder();
        progress.say("The logs are in %s.", stage.folder());
      }
      return isWell;
    } catch (IOException e) {
      progress.say("The stage could not be cleared: %s", e);
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

  private static void end(ProgressReporter progress, DemoEnvironment stage) throws Exception {
    progress.chapter("shutting down", "The end");
    stage.shutDown();
    DemoAssertions.require(
        stage.runningProcesses().isEmpty(), "processes " + stage.runningProcesses() + " still run");
    progress.say(
        "All is shut down: none of the %d processes of this demonstration is left.",
        stage.processCount());
  }

  private static void closeQuietly(DemoEnvironment stage) {
    try {
      stage.close();
    } catch (IOException e) {
      System.err.println(ConsoleMessages.prefixed(String.valueOf(e.getMessage())));
    }
  }
}
