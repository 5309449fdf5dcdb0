package org.dfra.recruit.agent;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import org.dfra.recruit.agent.AgentSnapshotStore.SteadyClock;
import org.dfra.recruit.transport.VirtualTime;
import org.junit.jupiter.api.Test;

class SteadyClockTest {

  @Test
  void goesOnFromWhereItBegan() {
    Instant began = Instant.parse("2026-11-21T00:00:00Z");
    VirtualTime timer = new VirtualTime(Instant.EPOCH);
    SteadyClock clock = new SteadyClock(began, timer);
    timer.advance(Duration.ofSeconds(5));
    assertThat(clock.instant()).isEqualTo(began.plusSeconds(5));
  }
}
