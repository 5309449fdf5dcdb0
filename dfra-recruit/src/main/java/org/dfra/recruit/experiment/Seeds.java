package org.dfra.recruit.experiment;

import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import java.util.stream.LongStream;

/** Seeds. Those that constants are chosen on judge nothing: the two sets have none in common. */
public final class Seeds {

  /** Lots of {@link #random} for delays of messages. */
  public static final int DELAYS = 1;

  /** Lots for which messages are lost. */
  public static final int LOSSES = 2;

  /** Lots for how late timers are. */
  public static final int TIMERS = 4;

  private static final long EVALUATION = 1_000_000;
  private static final long OTHERS = 100_000;

  private Seeds() {}

  /** To choose constants on; fewer than a million. */
  public static long[] tuning(int count) {
    check(count);
    return LongStream.range(0, count).toArray();
  }

  /** To judge by; fewer than a million. */
  public static long[] evaluation(int count) {
    check(count);
    return LongStream.range(EVALUATION, EVALUATION + count).toArray();
  }

  /** To judge by as well, and none of {@link #evaluation}'s first hundred thousand. */
  public static long[] replication(int count) {
    check(count);
    return LongStream.range(0, count).map(each -> EVALUATION + OTHERS + each).toArray();
  }

  /** The lots of a run for one purpose, so that one more drawn for it changes nothing else. */
  public static RandomGenerator random(long seed, int purpose) {
    return new SplittableRandom(seed * 1_000_003L + purpose);
  }

  private static void check(int count) {
    if (count < 1 || count >= EVALUATION) {
      throw new IllegalArgumentException(count + " seeds are outside 1 to " + (EVALUATION - 1));
    }
  }
}
