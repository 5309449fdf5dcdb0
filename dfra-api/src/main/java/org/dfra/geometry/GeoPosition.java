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

  /** Semi-major axis of the WGS84 ellipsoid in metres. */
  private static final double AXIS = 6_378_137;

  /** Square of the eccentricity of the WGS84 ellipsoid. */
  private static final double ECCENTRICITY_SQUARED = 6.694_379_990_141_3e-3;

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

  /**
   * The straight line to another position in metres, without heights: both positions are projected
   * to the ellipsoid. It is shorter than the distance along the ground by 1 m in 100 km, and by
   * less than 0.1 µm in 100 m.
   */
  public double groundDistance(GeoPosition other) {
    double[] here = onEllipsoid();
    double[] there = other.onEllipsoid();
    double x = here[0] - there[0];
    double y = here[1] - there[1];
    double z = here[2] - there[2];
    return Math.sqrt(x * x + y * y + z * z);
  }

  /** Earth-centred coordinates x, y, z in metres of the point below or above on the ellipsoid. */
  private double[] onEllipsoid() {
    double phi = Math.toRadians(latitude);
    double lambda = Math.toRadians(longitude);
    double sin = Math.sin(phi);
    double normal = AXIS / Math.sqrt(1 - ECCENTRICITY_SQUARED * sin * sin);
    return new double[] {
      normal * Math.cos(phi) * Math.cos(lambda),
      normal * Math.cos(phi) * Math.sin(lambda),
      normal * (1 - ECCENTRICITY_SQUARED) * sin
    };
  }
}
