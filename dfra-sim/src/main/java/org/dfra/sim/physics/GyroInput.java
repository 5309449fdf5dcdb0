package org.dfra.sim.physics;

import java.time.Instant;

/** Measures the yaw rate at a gyro's mount. */
@FunctionalInterface
public interface GyroInput {

  /**
   * The angular rate about its z axis, with bias, drift and noise.
   *
   * @return radians per second, to the left is +
   */
  double rate(Instant time);
}
