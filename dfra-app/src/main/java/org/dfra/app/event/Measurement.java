package org.dfra.app.event;

import java.time.Duration;
import java.util.EnumSet;
import java.util.concurrent.Callable;
import org.dfra.app.event.Listening.Ear;
import org.dfra.app.team.ModuleArgument;
import org.dfra.app.team.Team;
import org.dfra.app.terminal.ExitCode;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.Kind;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** A command that measures a module's events, and tells what it has every second and at the end. */
abstract class Measurement implements Callable<Integer> {

  private static final int WIDEST = 100_000;

  @Mixin
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private ModuleArgument module;

  @Mixin
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private ListeningOptions listening;

  @Option(
      names = "--window",
      paramLabel = "N",
      description = "Measure over the last N events (default ${DEFAULT-VALUE}).")
  private int window = 100;

  @Spec
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private CommandSpec spec;

  /** How large an event is, in bytes, where that is measured. */
  abstract long size(Delivery delivery);

  /** What was measured, for programs. */
  abstract Object value(EventWindow events, long lost);

  /** The same for people; at least two events came. */
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
            EnumSet.of(Kind.READING), DeliveryPolicy.DEEPEST, Double.POSITIVE_INFINITY);
    Meter meter = new Meter();
    try (Team team = module.open();
        Listening open = new Listening(module.in(team), meter, count)) {
      meter.tell(open.run(policy, time));
    }
    return ExitCode.WELL;
  }

  /** Fills the window. */
  private final class Meter implements Ear {

    private final EventWindow events = new EventWindow(window); // guarded by this
    private long toldAt = -1; // guarded by this

    @Override
    public boolean hear(Delivery delivery, long lost) {
      long now = System.nanoTime();
      long bytes = size(delivery);
      synchronized (this) {
        events.add(now, bytes);
      }
      return true;
    }

    @Override
    public boolean tick(long lost) {
      tell(lost);
      return module.answer().isRead();
    }

    synchronized void tell(long lost) {
      module.answer().line(value(events, lost), sentence(lost));
      toldAt = events.events();
    }

    private String sentence(long lost) {
      if (events.size() < 2) {
        return events.size() == 0 ? "no event so far" : "one event so far";
      }
      return inWords(events)
          + "; "
          + events.size()
          + " events"
          + (lost == 0 ? "" : ", " + lost + " lost")
          + (events.events() == toldAt ? "; none in the last second" : "");
    }
  }
}
