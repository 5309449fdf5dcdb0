package org.dfra.recruit.agent;

import java.time.Duration;
import java.time.Instant;
import org.dfra.time.Scheduler.ScheduledTask;
import org.jspecify.annotations.Nullable;

/** Wakes an agent at one time to come. Everything happens in its turns, but the waking. */
final class WakeTimer {

  private final RecruiterPorts ports;
  private final Runnable wake;
  private @Nullable ScheduledTask task;
  private Instant at = Instant.MAX;

  WakeTimer(RecruiterPorts ports, Runnable wake) {
    this.ports = ports;
    this.wake = wake;
  }

  /** Wakes then instead; never where that is {@link Instant#MAX}. */
  void set(Instant then) {
    if (then.equals(at)) {
      return;
    }
    if (task != null) {
      task.cancel();
    }
    at = then;
    task =
        then.equals(Instant.MAX)
            ? null
            : ports
                .scheduler()
                .after(Duration.between(ports.monotonicClock().instant(), then).toNanos(), wake);
  }

  /** It has woken; it may have been early by the clock, and is then set to the same time again. */
  void fired() {
    task = null;
    at = Instant.MAX;
  }
}
