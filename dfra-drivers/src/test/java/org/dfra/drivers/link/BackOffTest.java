package org.dfra.drivers.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.stream.IntStream;
import org.dfra.drivers.link.LinkKeeper.BackOff;
import org.junit.jupiter.api.Test;

class BackOffTest {

  @Test
  void doublesUpToTheLongest() {
    BackOff backOff = new BackOff(Duration.ofMillis(500), Duration.ofSeconds(3));
    assertThat(IntStream.rangeClosed(1, 6).mapToObj(n -> backOff.after(n).toMillis()))
        .containsExactly(500L, 1000L, 2000L, 3000L, 3000L, 3000L);
    assertThat(backOff.after(Integer.MAX_VALUE)).isEqualTo(Duration.ofSeconds(3));
  }

  @Test
  void refusesBoundsOutOfOrder() {
    assertThatThrownBy(() -> new BackOff(Duration.ofSeconds(2), Duration.ofSeconds(1)))
        .hasMessage("longest wait PT1S < first wait PT2S");
    assertThatThrownBy(() -> new BackOff(Duration.ZERO, Duration.ofSeconds(1)))
        .hasMessage("first wait PT0S is not longer than 0");
  }
}
