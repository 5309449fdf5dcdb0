package org.dfra.sim.physics;

import java.time.Instant;

/** The head of a pan-tilt unit: it carries and aims its devices. */
@FunctionalInterface
public interface PanTiltPhysics {

  /**
   * Sets the head's direction. The unit's own emulator moves it step by step.
   *
   * @param pan about z, radians, to the left is +
   * @param tilt about y after pan, radians, up is +
   */
  void point(Instant time, double pan, double tilt);
}
