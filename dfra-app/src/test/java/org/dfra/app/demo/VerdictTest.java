package org.dfra.app.demo;

import static org.assertj.core.api.Assertions.assertThat;

import org.dfra.app.figure.Figure;
import org.dfra.app.figure.Figures;
import org.junit.jupiter.api.Test;

/** What must be true decides how a demonstration ends; a missed time only where it is strict. */
class VerdictTest {

  private final Figures figures = new Figures();

  private boolean isWell(boolean isStrict) {
    return new Verdict(figures, isStrict).isWell();
  }

  private String said(boolean isStrict) {
    return String.join(" ", new Verdict(figures, isStrict).sentences(() -> 0.426));
  }

  @Test
  void aMissedTimeIsNoFailureUnlessItIsStrict() {
    figures.add(new Figure("gps_front killed to heard again", 7.3, 5, "s"));
    figures.add(new Figure("collisions", 0, 0, ""));
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
    figures.add(new Figure("troubles that did not come, or were not mended", 1, 0, ""));
    assertThat(isWell(false)).isFalse();
    assertThat(said(false))
        .isEqualTo(
            "FAILED: this must be true on every computer, and is not: troubles that did not come,"
                + " or were not mended.");
  }

  @Test
  void thePaceIsNotMeasuredWhereThereAreNoTimes() {
    figures.add(new Figure("collisions", 0, 0, ""));
    assertThat(
            new Verdict(figures, true)
                .sentences(
                    () -> {
                      throw new AssertionError("nobody asks");
                    }))
        .isEmpty();
    assertThat(isWell(true)).isTrue();
  }
}
