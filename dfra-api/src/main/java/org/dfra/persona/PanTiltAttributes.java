package org.dfra.persona;

/**
 * The limits of a pan-tilt unit.
 *
 * @param minPan right limit, radians, to the left is +
 * @param maxPan left limit, radians
 * @param minTilt lower limit, radians, up is +
 * @param maxTilt upper limit, radians
 * @param maxSpeed of each axis, radians per second
 */
public record PanTiltAttributes(
    double minPan, double maxPan, double minTilt, double maxTilt, double maxSpeed)
    implements Attributes {

  public PanTiltAttributes {
    if (!(minPan < maxPan && minTilt < maxTilt)) {
      throw new IllegalArgumentException(
          "pan "
              + minPan
              + " to "
              + maxPan
              + " rad, tilt "
              + minTilt
              + " to "
              + maxTilt
              + " rad are no ranges");
    }
    AttributeValidation.requirePositive("speed", maxSpeed, "rad/s");
  }
}
