package org.dfra.river.bootstrap;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class HeapOptionsTest {

  @Test
  void aGroupStartsWithASmallHeap() {
    assertThat(HeapOptions.of(List.of())).containsExactly("-Xms24m", "-Xmn8m");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"-Xmx24m", "-Xmx64M", "-Xmx1g", "-Xmx25165824", "-Xmx24576k", "-XX:+UseSerialGC"})
  void alsoIfItsLimitLeavesRoomForIt(String option) {
    assertThat(HeapOptions.of(List.of("-ea", option))).isNotEmpty();
  }

  /** The virtual machine refuses an initial heap that is larger than the limit. */
  @ParameterizedTest
  @ValueSource(strings = {"-Xmx16m", "-Xmx23M", "-Xmx8000k", "-Xmx25165823", "-Xmxmuch"})
  void butNotBelowThat(String option) {
    assertThat(HeapOptions.of(List.of(option))).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "-Xms100m",
        "-Xmn20m",
        "-XX:MaxRAMPercentage=1",
        "-XX:InitialRAMPercentage=5",
        "-XX:+UseG1GC",
        "-XX:+UseZGC",
        "-XX:+AlwaysPreTouch"
      })
  void aGroupThatShapesItsHeapDoesItAlone(String option) {
    assertThat(HeapOptions.of(List.of("-Xmx200m", option))).isEmpty();
  }
}
