package org.dfra.flow.effector;

import java.time.Instant;
import org.dfra.event.Reading;

/**
 * Where a pan-tilt head points.
 *
 * @param measured when it pointed there, UTC
 * @param frame name of the head's frame, e.g. {@code atrv1/pan_tilt}
 * @param pan about z, radians, to the left is +
 * @param tilt about y after pan, radians, up is +
 * @param isMoving whether it has not reached the commanded direction yet
 */
public record PanTiltState(
    Instant measured, String frame, double pan, double tilt, boolean isMoving) implements Reading {

  public PanTiltState {
    if (frame.isBlank()) {
      throw new IllegalArgumentException("a pan-tilt state names no frame");
    }
    if (!Double.isFinite(pan) || !Double.isFinite(tilt)) {
      throw new IllegalArgumentException(
          "direction " + pan + " rad, " + tilt + " rad is not finite");
    }
  }
}
