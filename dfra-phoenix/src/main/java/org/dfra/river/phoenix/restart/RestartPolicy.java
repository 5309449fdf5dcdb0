package org.dfra.river.phoenix.restart;

import java.time.Duration;

/**
 * When to restart a crashed group.
 *
 * <p>A group whose modules were ready for {@code minReadyTime} without interruption is restarted at
 * once, and its crash does not count. The first other crash causes no delay. Each further one
 * within the window doubles the delay, from {@code initialDelay} up to {@code maxDelay}. At {@code
 * crashLimit} such crashes within the window the group is held off: for {@code holdOff} no call can
 * start it, and after that only a call does.
 *
 * @param initialDelay delay after the second crash within the window
 * @param maxDelay bound of the doubling
 * @param crashLimit crashes within the window that make a crash loop, at least 2
 * @param window how long a crash counts
 * @param holdOff how long a crash-looping group is not restarted
 * @param minReadyTime how long its modules must have been ready without interruption for a crash
 *     not to count
 */
public record RestartPolicy(
    Duration initialDelay,
    Duration maxDelay,
    int crashLimit,
    Duration window,
    Duration holdOff,
    Duration minReadyTime) {

  /**
   * 0.1 s doubling to 10 s. Five crashes within a minute hold the group off for half a minute, if
   * its modules were not ready for 2 s.
   */
  public static final RestartPolicy DEFAULT =
      new RestartPolicy(
          Duration.ofMillis(100),
          Duration.ofSeconds(10),
          5,
          Duration.ofMinutes(1),
          Duration.ofSeconds(30),
          Duration.ofSeconds(2));

  public RestartPolicy {
    if (crashLimit < 2) {
      throw new IllegalArgumentException(
          "restartLimit " + crashLimit + " < 2; give 2 or more, since one crash is no loop");
    }
    if (initialDelay.compareTo(maxDelay) > 0) {
      throw new IllegalArgumentException(
          "restartDelay "
              + initialDelay
              + " > restartMaxDelay "
              + maxDelay
              + "; shorten restartDelay");
    }
  }

  /** The delay before the restart after the {@code crashes}-th crash within the window. */
  public Duration delay(int crashes) {
    if (crashes <= 1) {
      return Duration.ZERO;
    }
    long factor = 1L << Math.min(crashes - 2, 30);
    Duration delay = initialDelay.multipliedBy(factor);
    return delay.compareTo(maxDelay) < 0 ? delay : maxDelay;
  }
}
