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
            + " did not wait again within "
            + patience.toMillis() / 1e3
            + " s of real time; the cause's stack shows where it is; let it wait there with its"
            + " Ticker and a condition of Ticker.newCondition",
        at(thread));
  }

  private static Throwable at(Thread thread) {
    Throwable there = new Throwable(thread.getName() + " is here");
    there.setStackTrace(thread.getStackTrace());
    return there;
  }
}
