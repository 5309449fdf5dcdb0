package org.dfra.examples.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.IntStream;
import org.dfra.examples.mission.Scores.Deviation;
import org.junit.jupiter.api.Test;

class DeviationTest {

  @Test
  void ofAHundredDistancesNinetyFiveAreWithin() {
    Deviation off = Deviation.of(IntStream.rangeClosed(1, 100).mapToDouble(i -> -i).toArray());
    assertThat(off.mean()).isEqualTo(50.5);
    assertThat(off.rms()).isCloseTo(Math.sqrt(3383.5), within(1e-9)); // 101 · 201 / 6
    assertThat(off.within95()).isEqualTo(95);
    assertThat(off.most()).isEqualTo(100);
  }

  @Test
  void ofOneDistanceAllAreIt() {
    assertThat(Deviation.of(0.3)).isEqualTo(new Deviation(0.3, 0.3, 0.3, 0.3));
  }

  @Test
  void ofNoneThereIsNoNumber() {
    assertThat(Deviation.of().most()).isNaN();
  }
}
