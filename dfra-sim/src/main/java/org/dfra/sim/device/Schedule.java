package org.dfra.sim.device;

import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;

/** When a message is sent again. Confined to its device's thread. */
public final class Schedule {

  private Duration period = Duration.ZERO;
  private Instant next = Instant.MAX;

  /** Sets the period in seconds, from now on; 0 is never. */
  public void set(int seconds, Instant now) {
    set(Duration.ofSeconds(seconds), now);
  }

  /** Sets the period, from now on; zero is never. */
  public void set(Duration every, Instant now) {
    period = every;
    next = every.isZero() ? Instant.MAX : now.plus(period);
  }

  /** The last time due by now; null when there is none. Missed times are skipped. */
  public @Nullable Instant due(Instant now) {
    if (period.isZero()) {
      return null;
    }
    if (now.plus(period).isBefore(next)) { // the clock was set back
      next = now.plus(period);
    }
    if (now.isBefore(next)) {
      return null;
    }
    long missed = Duration.between(next, now).dividedBy(period);
    Instant due = next.plus(period.multipliedBy(missed));
    next = due.plus(period);
    return due;
  }
}
