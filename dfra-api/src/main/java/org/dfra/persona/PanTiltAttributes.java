package org.dfra.persona;

/**
 * Where a pan-tilt unit can point, and how fast.
 *
 * @param minPan farthest to the right, radians, to the left is +
 * @param maxPan farthest to the left, radians
 * @param minTilt farthest down, radians, up is +
 * @param maxTilt farthest up, radians
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
