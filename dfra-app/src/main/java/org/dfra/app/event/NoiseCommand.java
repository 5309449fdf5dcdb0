package org.dfra.app.event;

import java.time.Duration;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.dfra.app.event.ListeningSession.EventHandler;
import org.dfra.app.noise.NoiseParameter;
import org.dfra.app.noise.NoiseStudy;
import org.dfra.app.team.ModuleArgument;
import org.dfra.app.team.TeamDirectory;
import org.dfra.app.terminal.CommandFailure;
import org.dfra.app.terminal.ExitCode;
import org.dfra.app.terminal.Table;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.ModuleEvent;
import org.dfra.event.Reading;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra event noise}. */
@Command(
    name = "noise",
    description = "Measures the noise of a sensor while its robot stands.",
    footer = {
      "",
      "Of a GPS receiver, a gyro or a laser. Ends with --count, --for or Ctrl-C, and then",
      "tells the figures; docs/reference/sensor-noise.md says what to do with them."
    })
final class NoiseCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private ModuleArgument module;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private ListeningOptions listening;

  @Override
  public Integer call() throws Exception {
    long count = listening.count();
    Duration time = listening.time();
    DeliveryPolicy policy =
        listening.policy(
            EnumSet.of(EventKind.READING),
            DeliveryPolicy.MAX_QUEUE_DEPTH,
            Double.POSITIVE_INFINITY);
    NoiseCollector student = new NoiseCollector();
    try (TeamDirectory team = module.open();
        ListeningSession open = new ListeningSession(module.find(team), student, count)) {
      long lost = open.run(policy, time);
      print(student.figures());
      if (lost > 0) {
        module.answer().note((lost == 1 ? "one reading was" : lost + " readings were") + " lost");
      }
    }
    return ExitCode.SUCCESS;
  }

  private void print(List<NoiseParameter> figures) {
    Table table = new Table("FIGURE", "VALUE", "UNIT", "FROM");
    for (NoiseParameter each : figures) {
      table.row(
          each.name(),
          Double.isFinite(each.value()) ? String.format(Locale.ROOT, "%.4g", each.value()) : "-",
          each.unit(),
          each.basis());
    }
    module.answer().table(figures, table, "nothing was heard");
  }

  /** Collects the received readings. */
  private static final class NoiseCollector implements EventHandler {

    private @Nullable NoiseStudy study; // guarded by this
    private @Nullable String other; // guarded by this; a type without a study

    @Override
    public synchronized boolean onEvent(Delivery delivery, long lost) {
      if (!(delivery.event() instanceof ModuleEvent.NewReading fresh)) {
        return true;
      }
      Reading reading = fresh.reading();
      if (study == null) {
        study = NoiseStudy.of(reading).orElse(null);
        if (study == null) {
          other = reading.getClass().getSimpleName();
          return false;
        }
      }
      study.add(reading);
      return true;
    }

    @Override
    public boolean onSecond(long lost) {
      return true;
    }

    synchronized List<NoiseParameter> figures() {
      if (study == null) {
        throw new CommandFailure(
            ExitCode.FAILED,
            other == null
                ? "the module told nothing; see how it is: ./dfra module list"
                : "the module tells "
                    + other
                    + "; noise is measured of GpsFix, AngularRate and"
                    + " RangeScan");
      }
      return study.parameters();
    }
  }
}
