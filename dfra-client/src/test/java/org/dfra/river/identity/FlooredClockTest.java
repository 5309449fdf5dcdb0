package org.dfra.river.identity;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import org.junit.jupiter.api.Test;

/** A clock that may begin in 1970 after each start. */
class FlooredClockTest {

  private static final Instant NOON = Instant.parse("2026-11-28T12:00:00Z");
  private static final Instant LATEST = NOON.plus(Duration.ofDays(90));

  private Instant shown = NOON;
  private final FlooredClock clock = new FlooredClock(() -> shown, NOON, LATEST);

  @Test
  void aClockThatWasLostStandsAtTheLatestKnownTime() {
    shown = Instant.EPOCH;
    assertThat(clock.instant()).isEqualTo(NOON);
    assertThat(clock.isSet()).isFalse();
    assertThat(clock.time()).isEmpty();
    shown = NOON.plusSeconds(1);
    assertThat(clock.instant()).isEqualTo(shown);
    assertThat(clock.time()).contains(shown);
  }

  @Test
  void aSmallCorrectionLosesNoClock() {
    shown = NOON.minus(FlooredClock.TOLERANCE);
    assertThat(clock.time()).as("never backwards").contains(NOON);
    shown = shown.minusMillis(1);
    assertThat(clock.time()).isEmpty();
  }

  @Test
  void whatIsLearnedNeverGoesBackNorBeyondTheLastTime() {
    assertThat(clock.learn(NOON.plusSeconds(60))).isTrue();
    assertThat(clock.learn(NOON)).isTrue();
    assertThat(clock.floor()).isEqualTo(NOON.plusSeconds(60));
    assertThat(clock.learn(LATEST.plusSeconds(1))).as("nobody believes that").isFalse();
    assertThat(clock.floor()).isEqualTo(LATEST);
    assertThat(new FlooredClock(() -> shown, LATEST.plusSeconds(5), LATEST).floor())
        .isEqualTo(LATEST);
  }
}
