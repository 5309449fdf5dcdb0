package org.dfra.core.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dfra.time.Scheduler;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ScaledTimeTest {

  private static final Instant BEGIN = Instant.parse("2026-11-21T16:00:00Z");

  /** A real time that is moved by hand. */
  private static final class HandTime implements Scheduler {
    long nanos = 7_000;
    final List<Long> waits = new ArrayList<>();

    @Override
    public long nanos() {
      return nanos;
    }

    @Override
    public Task after(long wait, Runnable task) {
      waits.add(wait);
      return () -> {};
    }
  }

  private final HandTime real = new HandTime();

  @Test
  void runsAtItsSpeedFromTheInstantOnWhenItWasReal() {
    ScaledTime time = new ScaledTime(4, BEGIN, () -> BEGIN.plusSeconds(10), real);

    assertThat(time.instant()).isEqualTo(BEGIN.plusSeconds(40));
    real.nanos += 500_000_000;
    assertThat(time.instant()).isEqualTo(BEGIN.plusSeconds(42));
  }

  @Test
  void waitsShorterWhereItRunsFaster() {
    ScaledTime time = new ScaledTime(4, BEGIN, () -> BEGIN, real);

    Scheduler.Task unused = time.after(1_000, () -> {});

    assertThat(real.waits).containsExactly(250L);
  }

  @Test
  void doesNotJumpWhenTheComputersClockIsSet() {
    Instant[] clock = {BEGIN};
    ScaledTime time = new ScaledTime(2, BEGIN, () -> clock[0], real);

    clock[0] = BEGIN.plusSeconds(3600);

    assertThat(time.instant()).isEqualTo(BEGIN);
  }

  @Test
  void agreesWithAnotherVirtualMachineThatWasToldOfItLater() {
    ScaledTime early = new ScaledTime(2.5, BEGIN, () -> BEGIN, real);
    real.nanos += 2_000_000_000;
    ScaledTime late = new ScaledTime(2.5, BEGIN, () -> BEGIN.plusSeconds(2), real);

    assertThat(late.instant()).isEqualTo(early.instant()).isEqualTo(BEGIN.plusSeconds(5));
  }

  @ParameterizedTest
  @ValueSource(strings = {"4x since 2026-11-21T16:00:00Z", "0.5x since 2026-11-21T16:00:00.250Z"})
  void readsWhatItWrites(String text) {
    assertThat(ScaledTime.parse(text)).hasToString(text);
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "4x", "4 since 2026-11-21T16:00:00Z", "4x since noon", "..x since x"})
  void refusesWhatIsNoTime(String text) {
    assertThatThrownBy(() -> ScaledTime.parse(text))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("\"" + text + "\" is no time; write it like 4x since 2026-11-21T16:00:00Z");
  }

  @Test
  void refusesASpeedThatIsNone() {
    assertThatThrownBy(() -> ScaledTime.parse("0x since 2026-11-21T16:00:00Z"))
        .hasMessage("speed 0.0 is outside 0.01 to 1000.0");
  }
}
