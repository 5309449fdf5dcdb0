package org.dfra.sim.physics;

import java.time.Instant;

/** The head of a pan-tilt unit: what is mounted on it looks where it points. */
@FunctionalInterface
public interface PanTiltPhysics {

  /**
   * The head points there from now on. The unit's own emulator moves it step by step.
   *
   * @param pan about z, radians, to the left is +
   * @param tilt about y after pan, radians, up is +
   */
  void point(Instant time, double pan, double tilt);
}
