package org.dfra.cli.event;

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
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code ./dfra event echo}. */
@Command(
    name = "echo",
    description = "Shows a module's events as they arrive, one per line.",
    footer = {
      "",
      "Ends with --count, --for or Ctrl-C. A listener to readings is a client of the module",
      "and makes it work; a listener to other kinds only observes it. With --json, one JSON",
      "object per line."
    })
final class EchoCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private ModuleArgument module;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private ListeningOptions listening;

  @Option(
      names = "--rate",
      paramLabel = "HZ",
      description = "Events per second at most; in between, the module keeps the newest.")
  private double rate = Double.POSITIVE_INFINITY;

  @Option(
      names = "--depth",
      paramLabel = "N",
      description = "Events kept while the terminal is busy (default ${DEFAULT-VALUE}).")
  private int depth = 64;

  @Override
  public Integer call() throws Exception {
    long count = listening.count();
    Duration time = listening.time();
    DeliveryPolicy policy = listening.policy(EnumSet.allOf(EventKind.class), depth, rate);
    Lines lines = new Lines();
    try (TeamDirectory team = module.open();
        ListeningSession open = new ListeningSession(module.find(team), lines, count)) {
      long lost = open.run(policy, time);
      module
          .answer()
          .note(lines.shown + (lines.shown == 1 ? " event, " : " events, ") + lost + " lost");
    }
    return ExitCode.SUCCESS;
  }

  /** Prints a line for each event. */
  private final class Lines implements EventHandler {

    private volatile long shown;
    private long lostBefore;

    @Override
    @SuppressWarnings("NonAtomicVolatileUpdate") // events arrive one at a time
    public boolean onEvent(Delivery delivery, long lost) {
      EventLine line = EventLine.of(delivery, lost - lostBefore);
      lostBefore = lost;
      module.answer().line(line, line.inWords());
      shown++;
      return module.answer().isOutputOpen();
    }

    @Override
    public boolean onSecond(long lost) {
      return module.answer().isOutputOpen();
    }
  }
}
