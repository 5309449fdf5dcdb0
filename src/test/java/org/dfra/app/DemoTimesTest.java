package org.dfra.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.dfra.app.DemoTimes.Target;
import org.dfra.core.time.Timing;
import org.dfra.report.measurement.MeasuredValue;
import org.junit.jupiter.api.Test;

class DemoTimesTest {

  private static final int COLUMNS = 80;
  private static final Duration RUN = Duration.ofSeconds(90);
  private static final Timing IDLE = new Timing(RUN, Duration.ZERO, 0.6);
  private static final Timing STALLED = new Timing(RUN, Duration.ofSeconds(3), 0.6);
  private static final Timing OVERLOADED = new Timing(RUN, Duration.ZERO, 2.5);

  private static final MeasuredValue MET = new MeasuredValue("registrar back", 0.5, 5, "s");
  private static final MeasuredValue LATE =
      new MeasuredValue("gps_front killed to readings received again", 7.3, 5, "s");

  /** As a demonstration prints them. */
  private static DemoTimes read(MeasuredValue... figures) {
    String lines =
        Arrays.stream(figures)
            .flatMap(each -> each.lines(COLUMNS).stream())
            .collect(Collectors.joining("\n"));
    return DemoTimes.of("The end\n  all 3 s target ≤ lost\n\nMeasured\n" + lines + "\n\nMore\n");
  }

  @Test
  void readsWhatAFigurePrints() {
    MeasuredValue folded =
        new MeasuredValue(
            "cold start of both robots to all modules working and shown", 16.5, 16, "s");
    MeasuredValue stated =
        new MeasuredValue(
            "readings of the odometry in 1000 m", 20, Double.POSITIVE_INFINITY, "B/s");
    MeasuredValue foldedStated =
        new MeasuredValue(
            "share of the region that no robot of the 2 saw", 0.25, Double.POSITIVE_INFINITY, "");
    MeasuredValue plain = new MeasuredValue("waypoints to be driven to again, of 12", 0, 0, "");
    MeasuredValue small =
        new MeasuredValue("same-VM proxy call over the direct call", 0.00012, 0.5, "µs");
    assertThat(read(folded, stated, foldedStated, plain, small, LATE).targets())
        .containsExactly(
            new Target(folded.name(), 16.5, 16, "s", true),
            new Target(plain.name(), 0, 0, "", false),
            new Target(small.name(), 0.00012, 0.5, "µs", false),
            new Target(LATE.name(), 7.3, 5, "s", true));
  }

  @Test
  void aTargetThatCannotBeReadIsAFailure() {
    assertThatThrownBy(() -> DemoTimes.of("Measured\n  back soon  target ≤ 5 s  MISSED\n"))
        .isInstanceOf(AssertionError.class)
        .hasMessageContaining("back soon");
  }

  @Test
  void whatIsMetNeedsNoExcuse() {
    DemoTimes times = read(MET);
    assertThat(times.missed()).isEmpty();
    assertThat(times.excuses(STALLED)).isEmpty();
    times.require(IDLE);
  }

  @Test
  void aMissedTimeFailsWhereNothingWasSeen() {
    DemoTimes times = read(MET, LATE);
    assertThat(times.excuses(IDLE)).isEmpty();
    assertThatThrownBy(() -> times.require(IDLE))
        .isInstanceOf(AssertionError.class)
        .hasMessageStartingWith(
            "gps_front killed to readings received again took 7.300 s, bound 5.000 s");
  }

  @Test
  void aMissedTimeIsExcusedByAStallOrAnOverloadThatIsLongEnough() {
    DemoTimes times = read(MET, LATE);
    assertThat(times.excuses(STALLED))
        .containsExactly(
            "MISSED DURING A STALL: gps_front killed to readings received again: 7.3 s, target"
                + " ≤ 5.0; the computer stalled for 3.000 s of 90 s, with 0.6 runnable threads per"
                + " processor");
    assertThat(times.excuses(OVERLOADED))
        .singleElement()
        .asString()
        .startsWith("missed during an overload: gps_front killed to readings received again");
    assertThat(times.excuses(new Timing(RUN, Duration.ofSeconds(1), 0.6)))
        .as("6.3 s without it")
        .isEmpty();
  }

  @Test
  void oneThatNothingExcusesDecides() {
    MeasuredValue worse = new MeasuredValue("phoenix back", 60, 5, "s");
    assertThat(read(LATE, worse).excuses(STALLED)).isEmpty();
    assertThatThrownBy(() -> read(worse, LATE).require(STALLED))
        .hasMessageStartingWith("phoenix back took 60.000 s");
  }

  @Test
  void aMissThatRoundingHidesIsAMiss() {
    DemoTimes times = read(new MeasuredValue("registrar back", 5.0002, 5, "s"));
    assertThat(times.missed()).hasSize(1);
    assertThatThrownBy(() -> times.require(IDLE)).isInstanceOf(AssertionError.class);
  }

  @Test
  void whatIsNoTimeHasNoExcuse() {
    DemoTimes times = read(new MeasuredValue("collisions", 1, 0, ""));
    assertThatThrownBy(() -> times.excuses(STALLED))
        .isInstanceOf(AssertionError.class)
        .hasMessageContaining("is no time");
    assertThat(read().targets()).isEqualTo(List.of());
  }
}
