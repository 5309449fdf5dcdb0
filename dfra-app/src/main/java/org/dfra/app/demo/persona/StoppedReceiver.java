package org.dfra.app.demo.persona;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import org.dfra.app.demo.stage.Checks;
import org.dfra.app.demo.stage.FieldRobot;
import org.dfra.app.demo.stage.Narration;
import org.dfra.app.demo.stage.Stage;
import org.dfra.app.demo.stage.Wording;
import org.dfra.app.terminal.Table;

/** A receiver's process is stopped: it is reported, and nobody else waits for it. */
final class StoppedReceiver {

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  /** So many readings of the others show that they go on. */
  private static final int ENOUGH = 5;

  private final Narration tell;
  private final Stage stage;
  private final FieldRobot robot;

  StoppedReceiver(Narration tell, Stage stage, FieldRobot robot) {
    this.tell = tell;
    this.stage = stage;
    this.robot = robot;
  }

  /**
   * Stops a receiver's process and lets it go on.
   *
   * @param stopped the subscription to it
   * @param others subscriptions that should not suffer
   */
  void play(FixLog stopped, List<FixLog> others) throws Exception {
    tell.chapter("stopping a receiver", "kill -STOP: a process falls silent");
    FixLog.Arrival unused = stopped.next(PATIENCE);
    long process = robot.process(stopped.module());
    List<FixLog.Stretch> stretches = new ArrayList<>();
    FixLog.Stretch silence = stopped.begin();
    Narration.Stopwatch watch = tell.stopwatch();
    stage.signal("STOP", process);
    try {
      others.forEach(each -> stretches.add(each.begin()));
      Checks.await(
          "that the subscription to " + stopped.path() + " is reported as interrupted",
          PATIENCE,
          () -> stopped.subscription().interruptedSince().isPresent());
      Duration reported = watch.elapsed();
      tell.say(
          "Process %d, %s, was stopped. It closes no connection and answers nothing, as a robot out"
              + " of radio range. After %s the client's subscription to it reported that it is"
              + " interrupted.",
          process, stopped.path(), Wording.seconds(reported));
      tell.figure("silent receiver reported", reported, Duration.ofSeconds(3));
      for (FixLog.Stretch each : stretches) {
        each.await(ENOUGH, PATIENCE);
      }
      tellOfTheOthers(silence, stretches);
    } finally {
      stage.signal("CONT", process);
    }
    watch = tell.stopwatch();
    unused = stopped.next(PATIENCE);
    Duration again = watch.elapsed();
    Checks.await(
        "that the subscription to " + stopped.path() + " is whole again",
        PATIENCE,
        () -> stopped.subscription().interruptedSince().isEmpty());
    FixLog.Summary whole = silence.end();
    tell.say(
        "It was let go on (kill -CONT). Its readings came again after %s, and the subscription"
            + " reports no interruption any more; it counted %d lost events.",
        Wording.seconds(again), whole.lost());
  }

  private void tellOfTheOthers(FixLog.Stretch silence, List<FixLog.Stretch> others) {
    Table table = new Table("READINGS MEANWHILE", "NUMBER", "RATE", "LONGEST WAIT", "LOST");
    FixLog.Summary none = silence.end();
    table.row(none.path() + " (stopped)", Long.toString(none.readings()), "-", "-", "-");
    List<FixLog.Summary> all = others.stream().map(FixLog.Stretch::end).toList();
    for (FixLog.Summary each : all) {
      table.row(
          each.path(),
          Long.toString(each.readings()),
          String.format(Locale.ROOT, "%.2f Hz", each.rate()),
          Wording.seconds(each.longestWait()),
          Long.toString(each.lost()));
    }
    tell.say("Nothing else waited for it:");
    tell.show(table);
    tell.figure(
        "longest wait for a reading while another receiver is silent",
        all.stream()
            .map(FixLog.Summary::longestWait)
            .max(Comparator.naturalOrder())
            .orElse(Duration.ZERO),
        Duration.ofSeconds(2));
  }
}
