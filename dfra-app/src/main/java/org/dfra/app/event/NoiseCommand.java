package org.dfra.app.event;

import java.time.Duration;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.dfra.app.event.Listening.Ear;
import org.dfra.app.noise.NoiseFigure;
import org.dfra.app.noise.NoiseStudy;
import org.dfra.app.team.ModuleArgument;
import org.dfra.app.team.Team;
import org.dfra.app.terminal.CommandFailure;
import org.dfra.app.terminal.ExitCode;
import org.dfra.app.terminal.Table;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.Kind;
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
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private ModuleArgument module;

  @Mixin
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private ListeningOptions listening;

  @Override
  public Integer call() throws Exception {
    long count = listening.count();
    Duration time = listening.time();
    DeliveryPolicy policy =
        listening.policy(
            EnumSet.of(Kind.READING), DeliveryPolicy.DEEPEST, Double.POSITIVE_INFINITY);
    Student student = new Student();
    try (Team team = module.open();
        Listening open = new Listening(module.in(team), student, count)) {
      long lost = open.run(policy, time);
      tell(student.figures());
      if (lost > 0) {
        module.answer().remark((lost == 1 ? "one reading was" : lost + " readings were") + " lost");
      }
    }
    return ExitCode.WELL;
  }

  private void tell(List<NoiseFigure> figures) {
    Table table = new Table("FIGURE", "VALUE", "UNIT", "FROM");
    for (NoiseFigure each : figures) {
      table.row(
          each.name(),
          Double.isFinite(each.value()) ? String.format(Locale.ROOT, "%.4g", each.value()) : "-",
          each.unit(),
          each.basis());
    }
    module.answer().table(figures, table, "nothing was heard");
  }

  /** Hands over what is heard. */
  private static final class Student implements Ear {

    private @Nullable NoiseStudy study; // guarded by this
    private @Nullable String other; // guarded by this; what there is no study of

    @Override
    public synchronized boolean hear(Delivery delivery, long lost) {
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
      study.take(reading);
      return true;
    }

    @Override
    public boolean tick(long lost) {
      return true;
    }

    synchronized List<NoiseFigure> figures() {
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
      return study.figures();
    }
  }
}
