package org.dfra.geometry;

import java.io.Serializable;

/**
 * A position on or above the earth, frame WGS84.
 *
 * @param latitude geodetic latitude in degrees, −90 to 90, north is +
 * @param longitude longitude in degrees, −180 to 180, east is +
 * @param height height above the WGS84 ellipsoid in metres, up is +
 */
public record GeoPosition(double latitude, double longitude, double height)
    implements Serializable {

  public GeoPosition {
    if (!(Math.abs(latitude) <= 90)) {
      throw new IllegalArgumentException("latitude " + latitude + "° is outside −90° to 90°");
    }
    if (!(Math.abs(longitude) <= 180)) {
      throw new IllegalArgumentException("longitude " + longitude + "° is outside −180° to 180°");
    }
    if (!Double.isFinite(height)) {
      throw new IllegalArgumentException("height " + height + " m is not a finite number");
    }
  }
}
