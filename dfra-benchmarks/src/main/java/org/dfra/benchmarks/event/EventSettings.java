package org.dfra.benchmarks.event;

import java.time.Duration;

/**
 * How much is measured.
 *
 * @param repetitions how often each peer is measured, each time in new processes
 * @param listeners processes that listen
 * @param warmUp events before, published every {@code warmUpPeriod}
 * @param warmUpPeriod shorter than {@code period}, so that the warm-up does not take minutes
 * @param events events that are measured
 * @param period time between two of them
 */
public record EventSettings(
    int repetitions,
    int listeners,
    int warmUp,
    Duration warmUpPeriod,
    int events,
    Duration period) {

  /** For records: 20 listeners, 10 Hz. */
  public static final EventSettings FULL =
      new EventSettings(5, 20, 1000, Duration.ofMillis(20), 150, Duration.ofMillis(100));

  /** To try it; the figures are not to be compared. */
  public static final EventSettings QUICK =
      new EventSettings(1, 3, 20, Duration.ofMillis(20), 20, Duration.ofMillis(100));
}
