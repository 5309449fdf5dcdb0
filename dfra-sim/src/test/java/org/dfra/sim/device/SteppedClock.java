package org.dfra.sim.device;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.concurrent.atomic.AtomicReference;

/** A clock that stands until a test moves it on. */
final class SteppedClock implements InstantSource {

  private final AtomicReference<Instant> now;

  SteppedClock(Instant begin) {
    now = new AtomicReference<>(begin);
  }

  Instant step(Duration duration) {
    return now.updateAndGet(instant -> instant.plus(duration));
  }

  @Override
  public Instant instant() {
    return now.get();
  }
}
