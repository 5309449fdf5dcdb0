package org.dfra.drivers.device;

/** When a device is polled next: a timer with a variable period. Confined to one thread. */
public final class PollTimer {

  private long lastNanos;
  private boolean begun;

  /** Starts the timer; it is due immediately. */
  public void begin() {
    begun = false;
  }

  /**
   * Whether it is due; if so, the next period begins. Missed periods are skipped.
   *
   * @param now the time, nanoseconds
   * @param seconds the current period
   */
  public boolean isDue(long now, double seconds) {
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
