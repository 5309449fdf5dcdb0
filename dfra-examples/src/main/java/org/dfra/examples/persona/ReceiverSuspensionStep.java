package org.dfra.examples.persona;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.examples.harness.DemoRobot;
import org.dfra.report.progress.DemoAssertions;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.report.progress.QuantityText;
import org.dfra.report.terminal.Table;

/**
 * A receiver's process is suspended: the subscription reports it, and other clients are not
 * delayed.
 */
final class ReceiverSuspensionStep {

  private static final Duration PATIENCE = DemoEnvironment.PATIENCE;

  /** This number of readings shows that the others continue. */
  private static final int ENOUGH = 5;

  private final ProgressReporter progress;
  private final DemoEnvironment environment;
  private final DemoRobot robot;

  ReceiverSuspensionStep(ProgressReporter progress, DemoEnvironment environment, DemoRobot robot) {
    this.progress = progress;
    this.environment = environment;
    this.robot = robot;
  }

  /**
   * Suspends a receiver's process and resumes it.
   *
   * @param stopped the subscription to it
   * @param others subscriptions that should not be affected
   */
  void play(FixLog stopped, List<FixLog> others) throws Exception {
    progress.section("stopping a receiver", "kill -STOP: a process stops answering");
    FixLog.Arrival unused = stopped.next(PATIENCE);
    long process = robot.process(stopped.module());
    List<FixLog.RecordingPeriod> stretches = new ArrayList<>();
    FixLog.RecordingPeriod silence = stopped.begin();
    ProgressReporter.Stopwatch watch = progress.stopwatch();
    environment.signal("STOP", process);
    try {
      others.forEach(each -> stretches.add(each.begin()));
      DemoAssertions.await(
          "that the subscription to " + stopped.path() + " is reported as interrupted",
          PATIENCE,
          () -> stopped.subscription().interruptedSince().isPresent());
      Duration reported = watch.elapsed();
      progress.say(
          "Process %d, %s, was suspended. It closes no connection and does not answer, like a robot"
              + " out of radio range. After %s the client's subscription to it reported that it is"
              + " interrupted.",
          process, stopped.path(), QuantityText.seconds(reported));
      progress.figure("silent receiver reported", reported, Duration.ofSeconds(3));
      for (FixLog.RecordingPeriod each : stretches) {
        each.await(ENOUGH, PATIENCE);
      }
      reportOthers(silence, stretches);
    } finally {
      environment.signal("CONT", process);
    }
    watch = progress.stopwatch();
    unused = stopped.next(PATIENCE);
    Duration again = watch.elapsed();
    DemoAssertions.await(
        "that the subscription to " + stopped.path() + " is no longer interrupted",
        PATIENCE,
        () -> stopped.subscription().interruptedSince().isEmpty());
    FixLog.Summary whole = silence.end();
    progress.say(
        "It was resumed (kill -CONT). Its readings arrived again after %s, and the subscription no"
            + " longer reports an interruption; it counted %d lost events.",
        QuantityText.seconds(again), whole.lost());
  }

  private void reportOthers(FixLog.RecordingPeriod silence, List<FixLog.RecordingPeriod> others) {
    Table table = new Table("RECEIVER", "NUMBER", "RATE", "LONGEST WAIT", "LOST");
    FixLog.Summary none = silence.end();
    table.row(none.path() + " (suspended)", Long.toString(none.readings()), "-", "-", "-");
    List<FixLog.Summary> all = others.stream().map(FixLog.RecordingPeriod::end).toList();
    for (FixLog.Summary each : all) {
      table.row(
          each.path(),
          Long.toString(each.readings()),
          String.format(Locale.ROOT, "%.2f Hz", each.rate()),
          QuantityText.seconds(each.longestWait()),
          Long.toString(each.lost()));
    }
    progress.say("The other subscriptions were not delayed:");
    progress.show(table);
    progress.figure(
        "longest wait for a reading while another receiver is silent",
        all.stream()
            .map(FixLog.Summary::longestWait)
            .max(Comparator.naturalOrder())
            .orElse(Duration.ZERO),
        Duration.ofSeconds(2));
  }
}
