package org.dfra.sim.device;

import org.dfra.geometry.GeoPosition;

/**
 * Position and velocity of a receiver's antenna.
 *
 * @param position of the antenna, frame WGS84
 * @param speed over ground, metres per second, not negative
 * @param course direction of travel, degrees, 0 to less than 360, 0 is true north, clockwise is +
 */
public record AntennaState(GeoPosition position, double speed, double course) {

  public AntennaState {
    if (!(speed >= 0)) {
      throw new IllegalArgumentException("speed " + speed + " m/s is not ≥ 0");
    }
    if (!(course >= 0 && course < 360)) {
      throw new IllegalArgumentException("course " + course + "° is outside 0° to less than 360°");
    }
  }
}
