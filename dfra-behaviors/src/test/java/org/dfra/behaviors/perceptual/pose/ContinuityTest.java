package org.dfra.behaviors.perceptual.pose;

import static org.assertj.core.api.Assertions.assertThat;

import org.dfra.behaviors.perceptual.pose.Continuity.Verdict;
import org.junit.jupiter.api.Test;

class ContinuityTest {

  private final Continuity continuity = new Continuity();

  private Verdict at(double seconds) {
    return continuity.judge(Ticks.of(seconds));
  }

  @Test
  void goesOn() {
    assertThat(at(100)).isEqualTo(Verdict.FIRST);
    assertThat(at(101)).isEqualTo(Verdict.NEXT);
    assertThat(at(101)).isEqualTo(Verdict.OLD);
    assertThat(at(99)).isEqualTo(Verdict.OLD);
    assertThat(at(106)).isEqualTo(Verdict.NEXT);
  }

  @Test
  void believesALeapTheSecondTime() {
    at(100);
    assertThat(at(200)).isEqualTo(Verdict.SUSPECT);
    assertThat(at(100.1)).isEqualTo(Verdict.NEXT);
    assertThat(at(200)).isEqualTo(Verdict.SUSPECT);
    assertThat(at(-500)).isEqualTo(Verdict.SUSPECT);
    assertThat(at(-499)).isEqualTo(Verdict.BREAK);
    assertThat(at(-498)).isEqualTo(Verdict.NEXT);
  }
}
