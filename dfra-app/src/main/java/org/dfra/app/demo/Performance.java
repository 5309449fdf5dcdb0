package org.dfra.app.demo;

import java.io.IOException;
import org.dfra.core.log.LogLevels;
import org.dfra.module.LogLevel;

/**
 * Plays a demonstration on a stage of its own: what fails is told with the step in which it did,
 * figures end in a table, and whatever happens, everything is cleared away.
 */
final class Performance {

  /** Where somebody says which log is wanted. */
  private static final String LOG = "DFRA_LOG";

  private Performance() {}

  /** What is played. */
  interface Play {
    void on(Stage stage) throws Exception;
  }

  /**
   * Plays it.
   *
   * @return whether every step went well; figures that are not as wanted are no failure here
   */
  static boolean of(Narration tell, Play play) {
    if (System.getenv(LOG) == null) {
      LogLevels.service().set("org.dfra", LogLevel.ERROR); // it tells of its failures itself
    }
    try (Stage stage = new Stage()) {
      Runtime.getRuntime().addShutdownHook(new Thread(() -> closeQuietly(stage), "demo-end"));
      try {
        play.on(stage);
        end(tell, stage);
        tell.table();
        return true;
      } catch (Exception e) { // whatever goes wrong is what the demonstration has to tell
        stage.keepFolder();
        tell.heading("FAILED while " + tell.step());
        tell.say("%s", e.toString());
        tell.say("The logs are in %s.", stage.folder());
        return false;
      }
    } catch (IOException e) {
      tell.say("The stage could not be cleared: %s", e);
      return false;
    }
  }

  private static void end(Narration tell, Stage stage) throws Exception {
    tell.chapter("shutting down", "The end");
    stage.shutDown();
    Checks.require(stage.left().isEmpty(), "processes " + stage.left() + " still run");
    tell.say(
        "All is shut down: none of the %d processes of this demonstration is left.", stage.seen());
  }

  private static void closeQuietly(Stage stage) {
    try {
      stage.close();
    } catch (IOException e) {
      System.err.println("dfra: " + e.getMessage());
    }
  }
}
