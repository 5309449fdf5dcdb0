package org.dfra.sim.world;

import org.dfra.sim.world.noise.CorrelatedNoise;

/**
 * The last steps of a world, a row of numbers each, so that late queries get the state of their
 * time. Confined to the world's monitor.
 */
final class StateHistory {

  /** Number of steps stored. */
  static final int CAPACITY = CorrelatedNoise.REMEMBERED;

  private final double[][] rows;
  private long last;

  /**
   * @param width numbers in a row
   */
  StateHistory(int width) {
    rows = new double[CAPACITY][width];
  }

  /** The last step added; the first is 0. */
  long last() {
    return last;
  }

  /** Adds the row of the next step, to be filled. */
  double[] append() {
    last++;
    return rows[(int) (last % CAPACITY)];
  }

  /** The stored step nearest to the requested one. */
  long clampStep(long step) {
    return Math.max(Math.max(0, last - CAPACITY + 1), Math.min(step, last));
  }

  /** The row of a stored step. */
  double[] row(long step) {
    return rows[(int) (step % CAPACITY)];
  }
}
