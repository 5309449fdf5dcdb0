package org.dfra.module;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.stream.Collectors;
import org.dfra.lifecycle.Readiness;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class ReadinessTest {

  /** The arrows of the drawing above {@link Readiness}, written down a second time. */
  @ParameterizedTest
  @CsvSource({
    "CREATED,      INITIALIZING STOPPED",
    "INITIALIZING, READY FAILED STOPPED",
    "READY,        INITIALIZING ACTIVE PAUSED FAILED STOPPED",
    "ACTIVE,       INITIALIZING READY PAUSED FAILED STOPPED",
    "PAUSED,       READY ACTIVE FAILED STOPPED",
    "FAILED,       INITIALIZING STOPPED",
    "STOPPED,      ''",
  })
  void movesAlongTheDrawnArrowsOnly(Readiness from, String to) {
    assertThat(
            Arrays.stream(Readiness.values())
                .filter(from::canTransitionTo)
                .map(Readiness::name)
                .collect(Collectors.joining(" ")))
        .isEqualTo(to);
  }

  @ParameterizedTest
  @EnumSource
  void noStateHasAnArrowToItself(Readiness state) {
    assertThat(state.canTransitionTo(state)).isFalse();
  }

  @Test
  void servesWhileReadyOrActive() {
    assertThat(Readiness.values())
        .filteredOn(Readiness::serves)
        .containsExactly(Readiness.READY, Readiness.ACTIVE);
  }

  @Test
  void isHopelessWhenFailedOrStopped() {
    assertThat(Readiness.values())
        .filteredOn(Readiness::isFailedOrStopped)
        .containsExactly(Readiness.FAILED, Readiness.STOPPED);
  }
}
