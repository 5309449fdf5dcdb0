package org.dfra.drivers.laser.lms;

/** A timer with a variable period. Confined to one thread. */
final class PollTimer {

  private long lastNanos;
  private boolean begun;

  /** Starts the timer; it is due immediately. */
  void begin() {
    begun = false;
  }

  /** Whether it is due; if so, the next period begins. Missed periods are skipped. */
  boolean isDue(long now, double seconds) {
    long period = Math.round(1e9 * seconds);
    long late = now - lastNanos - period;
    if (begun && late < 0) {
      return false;
    }
    lastNanos = begun && late < period ? lastNanos + period : now;
    begun = true;
    return true;
  }
}
