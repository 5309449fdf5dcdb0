package org.dfra.drivers.pantilt.ptu;

import org.dfra.persona.PanTiltAttributes;

/**
 * The limits of the two axes, as reported by the unit.
 *
 * @param pan to the left is +
 * @param tilt up is +
 */
public record PtuGeometry(PtuAxisLimits pan, PtuAxisLimits tilt) {

  /** The attributes for discovery; the speed is that of the slower axis. */
  public PanTiltAttributes attributes() {
    return new PanTiltAttributes(
        pan.minAngle(),
        pan.maxAngle(),
        tilt.minAngle(),
        tilt.maxAngle(),
        Math.min(pan.fastestSpeed(), tilt.fastestSpeed()));
  }
}
