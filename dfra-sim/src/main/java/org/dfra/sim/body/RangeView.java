package org.dfra.sim.body;

import java.time.Instant;

/** What a range finder sees from where it is mounted. */
@FunctionalInterface
public interface RangeView {

  /**
   * Looks along beams in the plane of the range finder: noise, ghosts and other robots included.
   *
   * @param time when the mirror begins to turn
   * @param first angle of the first beam in the range finder's frame, radians, left is +
   * @param step from one beam to the next, radians; negative turns to the right
   * @param longest metres that the range finder can see
   * @param distances takes the distance of each beam, metres; positive infinity where it meets
   *     nothing within {@code longest}
   */
  void look(Instant time, double first, double step, double longest, double[] distances);
}
