package org.dfra.behaviors.perceptual.pose;

import static org.assertj.core.api.Assertions.assertThat;

import org.dfra.behaviors.perceptual.pose.TimestampMonitor.Classification;
import org.junit.jupiter.api.Test;

class TimestampMonitorTest {

  private final TimestampMonitor continuity = new TimestampMonitor();

  private Classification at(double seconds) {
    return continuity.classify(EpochNanos.of(seconds));
  }

  @Test
  void goesOn() {
    assertThat(at(100)).isEqualTo(Classification.FIRST);
    assertThat(at(101)).isEqualTo(Classification.NEXT);
    assertThat(at(101)).isEqualTo(Classification.OUT_OF_ORDER);
    assertThat(at(99)).isEqualTo(Classification.OUT_OF_ORDER);
    assertThat(at(106)).isEqualTo(Classification.NEXT);
  }

  @Test
  void believesALeapTheSecondTime() {
    at(100);
    assertThat(at(200)).isEqualTo(Classification.SUSPECT);
    assertThat(at(100.1)).isEqualTo(Classification.NEXT);
    assertThat(at(200)).isEqualTo(Classification.SUSPECT);
    assertThat(at(-500)).isEqualTo(Classification.SUSPECT);
    assertThat(at(-499)).isEqualTo(Classification.JUMP);
    assertThat(at(-498)).isEqualTo(Classification.NEXT);
  }
}
