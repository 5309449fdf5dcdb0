package org.dfra.app.demo;

import static org.assertj.core.api.Assertions.assertThat;

import org.dfra.app.measurement.MeasuredValue;
import org.dfra.app.measurement.RunMeasurements;
import org.junit.jupiter.api.Test;

/** What must be true decides how a demonstration ends; a missed time only where it is strict. */
class VerdictTest {

  private final RunMeasurements figures = new RunMeasurements();

  private boolean isWell(boolean isStrict) {
    return new DemoVerdict(figures, isStrict).passed();
  }

  private String said(boolean isStrict) {
    return String.join(" ", new DemoVerdict(figures, isStrict).sentences(() -> 0.426));
  }

  @Test
  void aMissedTimeIsNoFailureUnlessItIsStrict() {
    figures.add(new MeasuredValue("gps_front killed to heard again", 7.3, 5, "s"));
    figures.add(new MeasuredValue("collisions", 0, 0, ""));
    assertThat(isWell(false)).isTrue();
    assertThat(isWell(true)).isFalse();
    assertThat(said(false))
        .contains("can do 43 % of that now")
        .contains("1 time was MISSED: gps_front killed to heard again")
        .contains("no failure")
        .doesNotContain("FAILED");
    assertThat(said(true)).contains("With --strict that is a failure.");
  }

  @Test
  void whatMustBeTrueAndIsNotIsAFailure() {
    figures.add(new MeasuredValue("troubles that did not come, or were not mended", 1, 0, ""));
    assertThat(isWell(false)).isFalse();
    assertThat(said(false))
        .isEqualTo(
            "FAILED: this must be true on every computer, and is not: troubles that did not come,"
                + " or were not mended.");
  }

  @Test
  void thePaceIsNotMeasuredWhereThereAreNoTimes() {
    figures.add(new MeasuredValue("collisions", 0, 0, ""));
    assertThat(
            new DemoVerdict(figures, true)
                .sentences(
                    () -> {
                      throw new AssertionError("nobody asks");
                    }))
        .isEmpty();
    assertThat(isWell(true)).isTrue();
  }
}
