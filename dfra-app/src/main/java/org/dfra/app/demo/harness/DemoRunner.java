package org.dfra.app.demo.harness;

import java.io.IOException;
import org.dfra.app.log.LogbackSetup;
import org.dfra.app.terminal.ConsoleMessages;
import org.dfra.core.log.LogLevelControl;
import org.dfra.module.LogLevel;

/**
 * Plays a demonstration, usually on a stage of its own: what fails is told with the step in which
 * it did, figures end in a table, and whatever happens, everything is cleared away.
 */
public final class DemoRunner {

  private DemoRunner() {}

  /** What is played. */
  public interface EnvironmentDemo {
    void on(DemoEnvironment stage) throws Exception;
  }

  /** What is played without a stage. */
  public interface StandaloneDemo {
    void play() throws Exception;
  }

  /**
   * Plays it.
   *
   * @return whether every step went well; figures that are not as wanted are no failure here
   */
  public static boolean run(ProgressReporter tell, EnvironmentDemo play) {
    try (DemoEnvironment stage = new DemoEnvironment()) {
      Runtime.getRuntime().addShutdownHook(new Thread(() -> closeQuietly(stage), "demo-end"));
      boolean isWell =
          runStandalone(
              tell,
              () -> {
                play.on(stage);
                end(tell, stage);
              });
      if (!isWell) {
        stage.keepFolder();
        tell.say("The logs are in %s.", stage.folder());
      }
      return isWell;
    } catch (IOException e) {
      tell.say("The stage could not be cleared: %s", e);
      return false;
    }
  }

  /**
   * Plays what clears away by itself whatever it starts.
   *
   * @return whether every step went well; figures that are not as wanted are no failure here
   */
  public static boolean runStandalone(ProgressReporter tell, StandaloneDemo piece) {
    quietenLogs();
    try {
      piece.play();
      tell.table();
      return true;
    } catch (Exception e) { // whatever goes wrong is what the demonstration has to tell
      tell.freezeLive();
      tell.heading("FAILED while " + tell.step());
      tell.say("%s", e.toString());
      return false;
    }
  }

  /** Leaves the log to errors, unless somebody wants more: a demonstration tells itself. */
  private static void quietenLogs() {
    if (System.getenv(LogbackSetup.LEVEL) == null) {
      LogLevelControl.service().set("org.dfra", LogLevel.ERROR);
      LogLevelControl.service()
          .set("dfra", LogLevel.ERROR); // modules, where they run in this process
    }
  }

  private static void end(ProgressReporter tell, DemoEnvironment stage) throws Exception {
    tell.chapter("shutting down", "The end");
    stage.shutDown();
    DemoAssertions.require(
        stage.runningProcesses().isEmpty(), "processes " + stage.runningProcesses() + " still run");
    tell.say(
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
