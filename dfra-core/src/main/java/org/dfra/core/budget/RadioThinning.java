package org.dfra.core.budget;

import java.util.Arrays;

/**
 * Decides which readings are not sent, so that the traffic of a radio stays within its rate: of
 * each priority's readings every n-th is sent. While the rate is exceeded, n grows for the lowest
 * priority, and for the next one when n is {@value #MOST}. When less than half of the rate is used,
 * n is halved again for the highest priority that is thinned: that at most doubles its traffic, so
 * the rate is not exceeded by it.
 */
public final class RadioThinning {

  /** The largest n. */
  public static final int MOST = 64;

  private static final double RELAXED = 0.5;

  private RadioThinning() {}

  /** With all readings. */
  public static int[] none() {
    int[] all = new int[ListenerPriority.values().length];
    Arrays.fill(all, 1);
    return all;
  }

  /**
   * The next n of each priority.
   *
   * @param oneIn the present ones, by ordinal
   * @param rate measured, in bytes per second
   * @param max what the radio carries, in bytes per second
   */
  public static int[] next(int[] oneIn, double rate, double max) {
    int[] next = oneIn.clone();
    if (rate > max) {
      for (int i = 0; i < next.length; i++) {
        if (next[i] < MOST) {
          int factor = Integer.highestOneBit((int) Math.min(MOST, Math.ceil(rate / max)));
          next[i] = Math.min(MOST, next[i] * Math.max(2, factor));
          return next;
        }
      }
    } else if (rate < RELAXED * max) {
      for (int i = next.length - 1; i >= 0; i--) {
        if (next[i] > 1) {
          next[i] /= 2;
          return next;
        }
      }
    }
    return next;
  }
}
