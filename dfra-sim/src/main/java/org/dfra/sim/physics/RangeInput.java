package org.dfra.sim.physics;

import java.time.Instant;

/** What a range finder sees from where it is mounted. */
@FunctionalInterface
public interface RangeInput {

  /**
   * Looks along beams in the plane of the range finder: noise, ghosts and other robots included.
   *
   * @param time when the mirror begins to turn
   * @param firstAngle angle of the first beam in the range finder's frame, radians, left is +
   * @param angleStep from one beam to the next, radians; negative turns to the right
   * @param maxRange metres that the range finder can see
   * @param distances takes the distance of each beam, metres; positive infinity where it meets
   *     nothing within {@code longest}
   */
  void measure(
      Instant time, double firstAngle, double angleStep, double maxRange, double[] distances);
}
