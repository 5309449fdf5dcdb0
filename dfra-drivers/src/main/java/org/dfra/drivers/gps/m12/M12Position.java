package org.dfra.drivers.gps.m12;

import org.dfra.geometry.GeoPosition;

/**
 * A position in the receiver's format, frame WGS84.
 *
 * @param latitude degrees, −90 to 90, north is +
 * @param longitude degrees, −180 to 180, east is +
 * @param height above the WGS84 ellipsoid, metres
 * @param heightMsl above mean sea level, metres; the M12+ does not know it and always reports 0
 */
public record M12Position(double latitude, double longitude, double height, double heightMsl) {

  /** The position with its ellipsoidal height. */
  public GeoPosition toGeoPosition() {
    return new GeoPosition(latitude, longitude, height);
  }
}
