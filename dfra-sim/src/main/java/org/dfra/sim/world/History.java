package org.dfra.sim.world;

import org.dfra.sim.world.noise.Drift;

/**
 * The last steps of a world, a row of numbers each, so that who asks late is answered for the time
 * asked for. Confined to the world's monitor.
 */
final class History {

  /** Steps that are kept. */
  static final int KEPT = Drift.REMEMBERED;

  private final double[][] rows;
  private long last;

  /**
   * @param width numbers in a row
   */
  History(int width) {
    rows = new double[KEPT][width];
  }

  /** The step that was added last; the first is 0. */
  long last() {
    return last;
  }

  /** The row of the next step, to be filled. */
  double[] append() {
    last++;
    return rows[(int) (last % KEPT)];
  }

  /** The step nearest to one asked for that is kept. */
  long kept(long step) {
    return Math.max(Math.max(0, last - KEPT + 1), Math.min(step, last));
  }

  /** The row of a step that is kept. */
  double[] row(long step) {
    return rows[(int) (step % KEPT)];
  }
}
