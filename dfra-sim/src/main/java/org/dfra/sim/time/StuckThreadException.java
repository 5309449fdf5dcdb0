package org.dfra.sim.time;

import java.time.Duration;

/**
 * A scheduled thread did not wait again: it loops, or waits for something outside the simulated
 * time. The cause's stack trace is that thread's.
 */
public final class StuckThreadException extends IllegalStateException {

  private static final long serialVersionUID = 1;

  StuckThreadException(Thread thread, Duration patience) {
    super(
        thread.getName()
            + " has not come back to wait within "
            + patience.toMillis() / 1e3
            + " s of real time; see in the cause's stack where it is, and let it wait there by its"
            + " Ticker, with a condition of Ticker.newCondition",
        at(thread));
  }

  private static Throwable at(Thread thread) {
    Throwable there = new Throwable(thread.getName() + " is here");
    there.setStackTrace(thread.getStackTrace());
    return there;
  }
}
