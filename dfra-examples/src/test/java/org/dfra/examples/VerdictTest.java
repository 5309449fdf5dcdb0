package org.dfra.examples;

import static org.assertj.core.api.Assertions.assertThat;

import org.dfra.report.measurement.MeasuredValue;
import org.dfra.report.measurement.RunMeasurements;
import org.junit.jupiter.api.Test;

/** What must be true decides how a demonstration ends; a missed time only where it is strict. */
class VerdictTest {

  private final RunMeasurements figures = new RunMeasurements();

  private boolean isWell(boolean isStrict) {
    return new DemoVerdict(figures, isStrict).passed();
  }

  private String output(boolean isStrict) {
    return String.join(" ", new DemoVerdict(figures, isStrict).sentences(() -> 0.426));
  }

  @Test
  void aMissedTimeIsNoFailureUnlessItIsStrict() {
    figures.add(new MeasuredValue("gps_front killed to readings received again", 7.3, 5, "s"));
    figures.add(new MeasuredValue("collisions", 0, 0, ""));
    assertThat(isWell(false)).isTrue();
    assertThat(isWell(true)).isFalse();
    assertThat(output(false))
        .contains("now has 43 % of that speed")
        .contains("1 time was MISSED: gps_front killed to readings received again")
        .contains("not a failure")
        .doesNotContain("FAILED");
    assertThat(output(true)).contains("With --strict this is a failure.");
  }

  @Test
  void whatMustBeTrueAndIsNotIsAFailure() {
    figures.add(
        new MeasuredValue("injected faults that did not occur, or were not repaired", 1, 0, ""));
    assertThat(isWell(false)).isFalse();
    assertThat(output(false))
        .isEqualTo(
            "FAILED, although it does not depend on the computer's speed: injected faults that did"
                + " not occur, or were not repaired.");
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
