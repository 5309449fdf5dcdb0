package org.dfra.cli.event;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.dfra.cli.event.EventCommand.NumberFormats;
import org.dfra.cli.event.EventWindow.SummaryStatistics;
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
    SummaryStatistics intervals = window.intervals();
    assertThat(intervals.min()).isEqualTo(1);
    assertThat(intervals.max()).isEqualTo(2);
    assertThat(intervals.mean()).isEqualTo(1.5);
    assertThat(intervals.standardDeviation()).isEqualTo(0.5);
    assertThat(window.sizes())
        .extracting(SummaryStatistics::mean, SummaryStatistics::min, SummaryStatistics::max)
        .containsExactly(200.0, 100.0, 300.0);
    assertThat(window.bytesPerSecond()).isCloseTo(200 * 2.0 / 3, within(1e-9));
  }

  @Test
  void forgetsTheOldestButCountsThem() {
    for (int i = 0; i < 10; i++) {
      window.add(i < 6 ? i : 6 + (i - 6) * SECOND, i);
    }
    assertThat(window.totalCount()).isEqualTo(10);
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
  void numbersAreWrittenWithFourDigits() {
    assertThat(NumberFormats.fourDigits(0.99984)).isEqualTo("0.9998");
    assertThat(NumberFormats.fourDigits(12_345)).isEqualTo("12340");
    assertThat(NumberFormats.fourDigits(Double.NaN)).isEqualTo("an unknown number of");
    assertThat(NumberFormats.bytes(817)).isEqualTo("817 B");
    assertThat(NumberFormats.bytes(1234.5)).isEqualTo("1.234 kB");
    assertThat(NumberFormats.bytes(12_345_678)).isEqualTo("12.35 MB");
    assertThat(NumberFormats.orNull(Double.POSITIVE_INFINITY)).isNull();
  }
}
