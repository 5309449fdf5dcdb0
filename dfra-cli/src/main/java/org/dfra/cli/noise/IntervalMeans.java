package org.dfra.cli.noise;

import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;

/** The means over intervals of equal length; an interval counts when the next one has begun. */
final class IntervalMeans {

  private final long span; // nanoseconds
  private final SampleSeries means = new SampleSeries();
  private @Nullable Instant begin;
  private long current;
  private double sum;
  private int count;

  IntervalMeans(Duration span) {
    this.span = span.toNanos();
  }

  void add(Instant time, double value) {
    if (begin == null) {
      begin = time;
    }
    long index = Duration.between(begin, time).toNanos() / span;
    if (index != current && count > 0) {
      means.add(sum / count);
      sum = 0;
      count = 0;
    }
    current = index;
    sum += value;
    count++;
  }

  /** The means of the completed intervals. */
  SampleSeries series() {
    return means;
  }
}
