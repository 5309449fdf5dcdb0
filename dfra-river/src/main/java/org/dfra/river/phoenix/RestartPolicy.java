package org.dfra.river.phoenix;

import java.time.Duration;

/**
 * When a crashed group is started again.
 *
 * <p>A group whose modules had been ready for {@code worked} without interruption is started again
 * at once, and its crash does not count. Of the others the first one costs no delay. Each further
 * one within the window doubles the delay, from {@code firstDelay} up to {@code longestDelay}. At
 * {@code limit} such crashes within the window the group is held off: for {@code holdOff} nobody
 * can start it, and after that only a call does.
 *
 * @param initialDelay delay after the second crash within the window
 * @param maxDelay bound of the doubling
 * @param crashLimit crashes within the window that make a crash loop, at least 2
 * @param window how long a crash counts
 * @param holdOff how long a crash-looping group is left alone
 * @param minReadyTime how long its modules must have been ready without interruption for a crash
 *     not to count
 */
record RestartPolicy(
    Duration initialDelay,
    Duration maxDelay,
    int crashLimit,
    Duration window,
    Duration holdOff,
    Duration minReadyTime) {

  /**
   * 0.1 s doubling to 10 s; five crashes within a minute of modules that were not ready for 2 s
   * hold their group off for half a minute.
   */
  static final RestartPolicy DEFAULT =
      new RestartPolicy(
          Duration.ofMillis(100),
          Duration.ofSeconds(10),
          5,
          Duration.ofMinutes(1),
          Duration.ofSeconds(30),
          Duration.ofSeconds(2));

  RestartPolicy {
    if (crashLimit < 2) {
      throw new IllegalArgumentException(
          "restartLimit " + crashLimit + " < 2; one crash is no loop");
    }
    if (initialDelay.compareTo(maxDelay) > 0) {
      throw new IllegalArgumentException(
          "restartDelay " + initialDelay + " > restartLongestDelay " + maxDelay);
    }
  }

  /** The delay before the start that follows the {@code crashes}-th crash within the window. */
  Duration delay(int crashes) {
    if (crashes <= 1) {
      return Duration.ZERO;
    }
    long factor = 1L << Math.min(crashes - 2, 30);
    Duration delay = initialDelay.multipliedBy(factor);
    return delay.compareTo(maxDelay) < 0 ? delay : maxDelay;
  }
}
