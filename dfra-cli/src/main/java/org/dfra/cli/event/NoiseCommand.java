package org.dfra.cli.event;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Duration;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.dfra.cli.event.ListeningSession.EventHandler;
import org.dfra.cli.noise.NoiseStudy;
import org.dfra.cli.noise.NoiseStudy.NoiseParameter;
import org.dfra.cli.team.ModuleArgument;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.core.host.CommandName;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.ModuleEvent;
import org.dfra.event.Reading;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.dfra.report.terminal.Table;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra event noise}. */
@Command(
    name = "noise",
    description = "Measures the noise of a sensor while its robot does not move.",
    footer = {
      "",
      "Works for a GPS receiver, a gyro or a laser. Ends with --count, --for or Ctrl-C, and",
      "then prints the figures; docs/reference/sensor-noise.md explains how to use them."
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
    Table table = new Table("PARAMETER", "VALUE", "UNIT", "BASIS");
    for (NoiseParameter each : figures) {
      table.row(
          each.name(),
          Double.isFinite(each.value()) ? String.format(Locale.ROOT, "%.4g", each.value()) : "-",
          each.unit(),
          each.basis());
    }
    module.answer().table(figures, table, "no readings were received");
  }

  /** Collects the received readings. */
  private static final class NoiseCollector implements EventHandler {

    @GuardedBy("this")
    private @Nullable NoiseStudy study;

    // a type without a study
    @GuardedBy("this")
    private @Nullable String other;

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
                ? "the module sent no readings; see its state: "
                    + CommandName.current()
                    + " module list"
                : "the module sends "
                    + other
                    + "; noise is measured of GpsFix, AngularRate and"
                    + " RangeScan");
      }
      return study.parameters();
    }
  }
}
