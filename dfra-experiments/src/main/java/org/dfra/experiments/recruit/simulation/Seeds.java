package org.dfra.experiments.recruit.simulation;

import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import java.util.stream.LongStream;

/** Seeds. Tuning and evaluation use disjoint sets. */
public final class Seeds {

  /** Purpose of {@link #random}: message delays. */
  public static final int DELAYS = 1;

  /** Purpose: message losses. */
  public static final int LOSSES = 2;

  /** Purpose: timer delays. */
  public static final int TIMERS = 4;

  private static final long EVALUATION = 1_000_000;
  private static final long OTHERS = 100_000;

  private Seeds() {}

  /** Seeds for tuning; fewer than a million. */
  public static long[] tuning(int count) {
    check(count);
    return LongStream.range(0, count).toArray();
  }

  /** Seeds for evaluation; fewer than a million. */
  public static long[] evaluation(int count) {
    check(count);
    return LongStream.range(EVALUATION, EVALUATION + count).toArray();
  }

  /** Further seeds for evaluation, disjoint from {@link #evaluation}'s first hundred thousand. */
  public static long[] replication(int count) {
    check(count);
    return LongStream.range(0, count).map(each -> EVALUATION + OTHERS + each).toArray();
  }

  /**
   * The random numbers of a run for one purpose, so that an additional number does not affect other
   * purposes.
   */
  public static RandomGenerator random(long seed, int purpose) {
    return new SplittableRandom(seed * 1_000_003L + purpose);
  }

  private static void check(int count) {
    if (count < 1 || count >= EVALUATION) {
      throw new IllegalArgumentException(count + " seeds are outside 1 to " + (EVALUATION - 1));
    }
  }
}
