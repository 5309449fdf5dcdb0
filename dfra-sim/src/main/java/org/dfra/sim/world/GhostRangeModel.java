package org.dfra.sim.world;

import org.dfra.sim.world.noise.RandomStream;

/**
 * Ghosts of a laser: false short ranges that occur in clusters of beams and last for at most a few
 * scans, as uneven terrain causes them. Time is divided into slots with independent ghosts, so that
 * those at any time can be computed without earlier ones.
 */
final class GhostRangeModel {

  private static final double SLOT = 0.1; // seconds
  private static final int MOST_IN_SLOT = 16;
  private static final int EACH = 5; // random numbers per ghost
  private static final double SHORTEST = 0.5; // of the mean, for time and width
  private static final double LONGEST = 1.5;

  private final RandomStream draws;
  private final double perSlot;
  private final double time;
  private final double width;
  private final double near;
  private final double far;

  /** Receives the ghosts at a time, one by one. */
  @FunctionalInterface
  interface Taker {
    /**
     * @param bearing of its centre in the laser's frame, radians, to the left is +
     * @param halfWidth to both sides of that, radians
     * @param distance metres
     */
    void ghost(double bearing, double halfWidth, double distance);
  }

  /**
   * @param rate ghosts per second in the front half of the laser's circle
   * @param time mean duration, seconds
   * @param width mean angular width, radians
   * @param near minimum distance, metres
   * @param far maximum distance, metres
   */
  GhostRangeModel(
      RandomStream draws, double rate, double time, double width, double near, double far) {
    this.draws = draws;
    this.perSlot = rate * SLOT;
    this.time = time;
    this.width = width;
    this.near = Math.min(near, far);
    this.far = Math.max(near, far);
  }

  /** Reports the ghosts at this time, seconds since the start of the world. */
  void forEachAt(double seconds, Taker taker) {
    if (perSlot == 0) {
      return;
    }
    long last = (long) Math.floor(seconds / SLOT);
    long first = (long) Math.floor((seconds - LONGEST * time) / SLOT);
    for (long slot = first; slot <= last; slot++) {
      RandomStream here = draws.substream(slot);
      int count = count(here.uniform(0));
      for (int i = 0; i < count; i++) {
        int draw = 1 + EACH * i;
        double from = (slot + here.uniform(draw)) * SLOT;
        double lasts = time * (SHORTEST + (LONGEST - SHORTEST) * here.uniform(draw + 1));
        if (from <= seconds && seconds < from + lasts) {
          taker.ghost(
              Math.PI * (here.uniform(draw + 2) - 0.5),
              width / 2 * (SHORTEST + (LONGEST - SHORTEST) * here.uniform(draw + 3)),
              near + (far - near) * here.uniform(draw + 4));
        }
      }
    }
  }

  /**
   * Number of ghosts in a slot: Poisson-distributed, by the inverse of its cumulative distribution.
   */
  private int count(double uniform) {
    double probability = StrictMath.exp(-perSlot);
    double below = probability;
    int count = 0;
    while (uniform > below && count < MOST_IN_SLOT) {
      count++;
      probability *= perSlot / count;
      below += probability;
    }
    return count;
  }
}
