package org.dfra.sim.device;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;

/** A clock that stands until a test moves it on. */
public final class SteppedClock implements InstantSource {

  private final AtomicReference<Instant> now;
  private final AtomicLong looks = new AtomicLong();

  public SteppedClock(Instant begin) {
    now = new AtomicReference<>(begin);
  }

  public Instant step(Duration duration) {
    return now.updateAndGet(instant -> instant.plus(duration));
  }

  /**
   * How often somebody has looked at it. Two more than before, and who looks again and again has
   * done all that was due at what it showed.
   */
  public long looks() {
    return looks.get();
  }

  @Override
  public Instant instant() {
    looks.incrementAndGet();
    return now.get();
  }
}
