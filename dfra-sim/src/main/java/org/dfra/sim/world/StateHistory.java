package org.dfra.sim.world;

import org.dfra.sim.world.noise.CorrelatedNoise;

/**
 * The last steps of a world, a row of numbers each, so that who asks late is answered for the time
 * asked for. Confined to the world's monitor.
 */
final class StateHistory {

  /** Steps that are kept. */
  static final int CAPACITY = CorrelatedNoise.REMEMBERED;

  private final double[][] rows;
  private long last;

  /**
   * @param width numbers in a row
   */
  StateHistory(int width) {
    rows = new double[CAPACITY][width];
  }

  /** The step that was added last; the first is 0. */
  long last() {
    return last;
  }

  /** The row of the next step, to be filled. */
  double[] append() {
    last++;
    return rows[(int) (last % CAPACITY)];
  }

  /** The step nearest to one asked for that is kept. */
  long clampStep(long step) {
    return Math.max(Math.max(0, last - CAPACITY + 1), Math.min(step, last));
  }

  /** The row of a step that is kept. */
  double[] row(long step) {
    return rows[(int) (step % CAPACITY)];
  }
}
