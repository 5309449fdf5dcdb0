package org.dfra.recruit.agent;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.atomic.AtomicReference;
import org.dfra.recruit.transport.VirtualTime;
import org.junit.jupiter.api.Test;

class SteadyClockTest {

  @Test
  void goesOnAsItWasWhereTheComputersClockIsSet() {
    Instant began = Instant.parse("2026-11-21T00:00:00Z");
    AtomicReference<Instant> computers = new AtomicReference<>(began);
    VirtualTime timer = new VirtualTime(Instant.EPOCH);
    SteadyClock clock = new SteadyClock(computers::get, timer);
    timer.advance(Duration.ofSeconds(5));
    computers.set(began.minus(Duration.ofDays(1)));
    assertThat(clock.instant()).isEqualTo(began.plusSeconds(5));
  }
}
