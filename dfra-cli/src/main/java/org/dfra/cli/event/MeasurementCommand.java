package org.dfra.cli.event;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Duration;
import java.util.EnumSet;
import java.util.concurrent.Callable;
import org.dfra.cli.event.ListeningSession.EventHandler;
import org.dfra.cli.team.ModuleArgument;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.report.terminal.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** A command that measures a module's events, and reports every second and at the end. */
abstract class MeasurementCommand implements Callable<Integer> {

  private static final int WIDEST = 100_000;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private ModuleArgument module;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private ListeningOptions listening;

  @Option(
      names = "--window",
      paramLabel = "N",
      description = "Measure over the last N events (default ${DEFAULT-VALUE}).")
  private int window = 100;

  @Spec
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandSpec spec;

  /** An event's size in bytes, if the command measures it. */
  abstract long size(Delivery delivery);

  /** The measurements in JSON output. */
  abstract Object value(EventWindow events, long lost);

  /** The same as text output, for at least two events. */
  abstract String inWords(EventWindow events);

  @Override
  public final Integer call() throws Exception {
    if (window < 2 || window > WIDEST) {
      throw new ParameterException(
          spec.commandLine(), "--window=" + window + " is not a number from 2 to " + WIDEST);
    }
    long count = listening.count();
    Duration time = listening.time();
    DeliveryPolicy policy =
        listening.policy(
            EnumSet.of(EventKind.READING),
            DeliveryPolicy.MAX_QUEUE_DEPTH,
            Double.POSITIVE_INFINITY);
    Meter meter = new Meter();
    try (TeamDirectory team = module.open();
        ListeningSession open = new ListeningSession(module.find(team), meter, count)) {
      meter.report(open.run(policy, time));
    }
    return ExitCode.SUCCESS;
  }

  /** Fills the window. */
  private final class Meter implements EventHandler {

    @GuardedBy("this")
    private final EventWindow events = new EventWindow(window);

    @GuardedBy("this")
    private long reportedAt = -1;

    @Override
    public boolean onEvent(Delivery delivery, long lost) {
      long now = System.nanoTime();
      long bytes = size(delivery);
      synchronized (this) {
        events.add(now, bytes);
      }
      return true;
    }

    @Override
    public boolean onSecond(long lost) {
      report(lost);
      return module.answer().isOutputOpen();
    }

    synchronized void report(long lost) {
      module.answer().line(value(events, lost), sentence(lost));
      reportedAt = events.totalCount();
    }

    @GuardedBy("this")
    private String sentence(long lost) {
      if (events.size() < 2) {
        return events.size() == 0 ? "no event so far" : "one event so far";
      }
      return inWords(events)
          + "; "
          + events.size()
          + " events"
          + (lost == 0 ? "" : ", " + lost + " lost")
          + (events.totalCount() == reportedAt ? "; none in the last second" : "");
    }
  }
}
