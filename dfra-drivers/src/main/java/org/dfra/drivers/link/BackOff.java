package org.dfra.drivers.link;

import java.time.Duration;

/**
 * How long to wait before the next try: the first wait, then twice as long each time, up to the
 * longest.
 *
 * @param first the first wait, longer than 0
 * @param longest the longest wait, at least {@code first}
 */
public record BackOff(Duration first, Duration longest) {

  public BackOff {
    if (first.isNegative() || first.isZero()) {
      throw new IllegalArgumentException("first wait " + first + " is not longer than 0");
    }
    if (longest.compareTo(first) < 0) {
      throw new IllegalArgumentException("longest wait " + longest + " < first wait " + first);
    }
  }

  /**
   * The wait after so many tries in vain.
   *
   * @param failures tries in vain since the last one that was not, at least 1
   */
  public Duration after(int failures) {
    int doublings = Math.min(Math.max(0, failures - 1), 30);
    long nanos = first.toNanos();
    return nanos > longest.toNanos() >> doublings ? longest : Duration.ofNanos(nanos << doublings);
  }
}
