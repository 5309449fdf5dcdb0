package org.dfra.app.demo.stage;

import java.io.IOException;
import org.dfra.app.log.LogbackSetup;
import org.dfra.app.terminal.Sentences;
import org.dfra.core.log.LogLevels;
import org.dfra.module.LogLevel;

/**
 * Plays a demonstration, usually on a stage of its own: what fails is told with the step in which
 * it did, figures end in a table, and whatever happens, everything is cleared away.
 */
public final class Performance {

  private Performance() {}

  /** What is played. */
  public interface Play {
    void on(Stage stage) throws Exception;
  }

  /** What is played without a stage. */
  public interface Piece {
    void play() throws Exception;
  }

  /**
   * Plays it.
   *
   * @return whether every step went well; figures that are not as wanted are no failure here
   */
  public static boolean of(Narration tell, Play play) {
    try (Stage stage = new Stage()) {
      Runtime.getRuntime().addShutdownHook(new Thread(() -> closeQuietly(stage), "demo-end"));
      boolean isWell =
          withoutStage(
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
  public static boolean withoutStage(Narration tell, Piece piece) {
    hush();
    try {
      piece.play();
      tell.table();
      return true;
    } catch (Exception e) { // whatever goes wrong is what the demonstration has to tell
      tell.settle();
      tell.heading("FAILED while " + tell.step());
      tell.say("%s", e.toString());
      return false;
    }
  }

  /** Leaves the log to errors, unless somebody wants more: a demonstration tells itself. */
  private static void hush() {
    if (System.getenv(LogbackSetup.LEVEL) == null) {
      LogLevels.service().set("org.dfra", LogLevel.ERROR);
      LogLevels.service().set("dfra", LogLevel.ERROR); // modules, where they run in this process
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
      System.err.println(Sentences.remark(String.valueOf(e.getMessage())));
    }
  }
}
