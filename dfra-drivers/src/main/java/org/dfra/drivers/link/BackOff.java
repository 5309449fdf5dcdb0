package org.dfra.drivers.link;

import java.time.Duration;

/**
 * How long to wait before the next try: the first wait, then twice as long each time, up to the
 * longest.
 *
 * @param initial the first wait, longer than 0
 * @param max the longest wait, at least {@code first}
 */
public record BackOff(Duration initial, Duration max) {

  public BackOff {
    if (initial.isNegative() || initial.isZero()) {
      throw new IllegalArgumentException("first wait " + initial + " is not longer than 0");
    }
    if (max.compareTo(initial) < 0) {
      throw new IllegalArgumentException("longest wait " + max + " < first wait " + initial);
    }
  }

  /**
   * The wait after so many tries in vain.
   *
   * @param failures tries in vain since the last one that was not, at least 1
   */
  public Duration after(int failures) {
    int doublings = Math.min(Math.max(0, failures - 1), 30);
    long nanos = initial.toNanos();
    return nanos > max.toNanos() >> doublings ? max : Duration.ofNanos(nanos << doublings);
  }
}
