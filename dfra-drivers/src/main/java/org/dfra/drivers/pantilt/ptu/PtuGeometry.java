package org.dfra.drivers.pantilt.ptu;

import org.dfra.persona.PanTiltAttributes;

/**
 * What the unit has told of its two axes.
 *
 * @param pan to the left is +
 * @param tilt up is +
 */
public record PtuGeometry(PtuAxisLimits pan, PtuAxisLimits tilt) {

  /** As others may search for it; the speed is that of the slower axis. */
  public PanTiltAttributes attributes() {
    return new PanTiltAttributes(
        pan.minAngle(),
        pan.maxAngle(),
        tilt.minAngle(),
        tilt.maxAngle(),
        Math.min(pan.fastestSpeed(), tilt.fastestSpeed()));
  }
}
