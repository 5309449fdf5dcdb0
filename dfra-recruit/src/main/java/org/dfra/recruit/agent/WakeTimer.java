package org.dfra.recruit.agent;

import java.time.Duration;
import java.time.Instant;
import org.dfra.time.Scheduler.ScheduledTask;
import org.jspecify.annotations.Nullable;

/**
 * Wakes an agent at one future time. Except for the wake-up, it runs only inside the agent's event
 * queue.
 */
final class WakeTimer {

  private final RecruiterPorts ports;
  private final Runnable wake;
  private @Nullable ScheduledTask task;
  private Instant at = Instant.MAX;

  WakeTimer(RecruiterPorts ports, Runnable wake) {
    this.ports = ports;
    this.wake = wake;
  }

  /** Sets the time; {@link Instant#MAX} means never. */
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

  /** Handles the wake-up; if it was early by the clock, the timer is set to the same time again. */
  void fired() {
    task = null;
    at = Instant.MAX;
  }
}
