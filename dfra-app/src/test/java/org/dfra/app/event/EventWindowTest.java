package org.dfra.app.event;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class EventWindowTest {

  private static final long SECOND = 1_000_000_000L;

  private final EventWindow window = new EventWindow(4);

  @Test
  void measuresRateAndIntervals() {
    window.add(0, 100);
    window.add(SECOND, 200);
    window.add(3 * SECOND, 300);
    assertThat(window.rate()).as("two intervals in 3 s").isEqualTo(2.0 / 3);
    Spread intervals = window.intervals();
    assertThat(intervals.min()).isEqualTo(1);
    assertThat(intervals.max()).isEqualTo(2);
    assertThat(intervals.mean()).isEqualTo(1.5);
    assertThat(intervals.deviation()).isEqualTo(0.5);
    assertThat(window.sizes())
        .extracting(Spread::mean, Spread::min, Spread::max)
        .containsExactly(200.0, 100.0, 300.0);
    assertThat(window.bytesPerSecond()).isCloseTo(200 * 2.0 / 3, within(1e-9));
  }

  @Test
  void forgetsTheOldestButCountsThem() {
    for (int i = 0; i < 10; i++) {
      window.add(i < 6 ? i : 6 + (i - 6) * SECOND, i);
    }
    assertThat(window.events()).isEqualTo(10);
    assertThat(window.size()).isEqualTo(4);
    assertThat(window.rate()).isEqualTo(1);
    assertThat(window.sizes().min()).isEqualTo(6);
  }

  @Test
  void knowsNothingOfFewerThanTwo() {
    assertThat(window.rate()).isNaN();
    assertThat(window.sizes().mean()).isNaN();
    window.add(5, 7);
    assertThat(window.rate()).isNaN();
    assertThat(window.intervals().min()).isNaN();
    assertThat(window.bytesPerSecond()).isNaN();
    assertThat(window.sizes().mean()).isEqualTo(7);
  }

  @Test
  void numbersAreToldWithFourDigits() {
    assertThat(Numbers.fourDigits(0.99984)).isEqualTo("0.9998");
    assertThat(Numbers.fourDigits(12_345)).isEqualTo("12340");
    assertThat(Numbers.fourDigits(Double.NaN)).isEqualTo("an unknown number of");
    assertThat(Numbers.bytes(817)).isEqualTo("817 B");
    assertThat(Numbers.bytes(1234.5)).isEqualTo("1.234 kB");
    assertThat(Numbers.bytes(12_345_678)).isEqualTo("12.35 MB");
    assertThat(Numbers.orNull(Double.POSITIVE_INFINITY)).isNull();
  }
}
