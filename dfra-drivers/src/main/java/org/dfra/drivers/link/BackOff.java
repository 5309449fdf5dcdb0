package org.dfra.drivers.link;

import java.time.Duration;

/**
 * How long to wait before the next attempt: the initial wait, doubled each time, up to the maximum.
 *
 * @param initial the initial wait, longer than 0
 * @param max the maximum wait, at least {@code initial}
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
   * The wait after a number of consecutive failures.
   *
   * @param failures failures since the last success, at least 1
   */
  public Duration after(int failures) {
    int doublings = Math.min(Math.max(0, failures - 1), 30);
    long nanos = initial.toNanos();
    return nanos > max.toNanos() >> doublings ? max : Duration.ofNanos(nanos << doublings);
  }
}
