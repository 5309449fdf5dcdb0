package org.dfra.drivers.laser.lms;

/**
 * When something is due again that is done every so many seconds, which may change. Confined to one
 * thread.
 */
final class PollTimer {

  private long lastNanos;
  private boolean begun;

  /** It is due at once. */
  void begin() {
    begun = false;
  }

  /** Whether it is due; if so, it counts as done. What was missed is left out. */
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
