package org.dfra.sim.physics;

import java.time.Instant;

/** What a rate gyro feels where it is mounted. */
@FunctionalInterface
public interface GyroInput {

  /**
   * The rate at which it turns about its z axis, with bias, drift and noise.
   *
   * @return radians per second, to the left is +
   */
  double rate(Instant time);
}
