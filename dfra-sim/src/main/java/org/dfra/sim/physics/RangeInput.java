package org.dfra.sim.physics;

import java.time.Instant;

/** Measures ranges from a range finder's mount. */
@FunctionalInterface
public interface RangeInput {

  /**
   * Measures along beams in the plane of the range finder; includes noise, ghosts and other robots.
   *
   * @param time at which the mirror's rotation starts
   * @param firstAngle angle of the first beam in the range finder's frame, radians, left is +
   * @param angleStep from one beam to the next, radians; negative is to the right
   * @param maxRange maximum range, metres
   * @param distances receives the distance of each beam, metres; positive infinity where it hits
   *     nothing within {@code maxRange}
   */
  void measure(
      Instant time, double firstAngle, double angleStep, double maxRange, double[] distances);
}
