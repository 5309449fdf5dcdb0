package org.dfra.geometry;

/**
 * The local east-north-up frame of a datum on the WGS84 ellipsoid: geodetic coordinates to
 * earth-centred ones (ECEF), less the datum's, turned into the datum's horizon. Exact at any
 * distance. Source: NIMA TR8350.2, WGS84 parameters; the formulas are textbook geodesy.
 *
 * <p>Immutable; made once for a datum, it costs one conversion per position.
 */
public final class LocalFrame {

  /** Equatorial radius of the WGS84 ellipsoid, metres. */
  public static final double EQUATORIAL_RADIUS = 6_378_137.0;

  /** Flattening of the WGS84 ellipsoid. */
  public static final double FLATTENING = 1 / 298.257223563;

  private static final double ECCENTRICITY_SQUARED = FLATTENING * (2 - FLATTENING);

  private final GeoPosition datum;
  private final double[] origin;
  private final double sinLatitude;
  private final double cosLatitude;
  private final double sinLongitude;
  private final double cosLongitude;

  /**
   * @param datum where east, north and up are zero
   */
  public LocalFrame(GeoPosition datum) {
    this.datum = datum;
    this.origin = earthCentred(datum);
    double latitude = Math.toRadians(datum.latitude());
    double longitude = Math.toRadians(datum.longitude());
    this.sinLatitude = Math.sin(latitude);
    this.cosLatitude = Math.cos(latitude);
    this.sinLongitude = Math.sin(longitude);
    this.cosLongitude = Math.cos(longitude);
  }

  /** Where east, north and up are zero. */
  public GeoPosition datum() {
    return datum;
  }

  /** The position in this frame. */
  public LocalPosition toLocal(GeoPosition position) {
    double[] at = earthCentred(position);
    double dx = at[0] - origin[0];
    double dy = at[1] - origin[1];
    double dz = at[2] - origin[2];
    double outward = cosLongitude * dx + sinLongitude * dy;
    return new LocalPosition(
        cosLongitude * dy - sinLongitude * dx,
        cosLatitude * dz - sinLatitude * outward,
        sinLatitude * dz + cosLatitude * outward);
  }

  /** Earth-centred, earth-fixed coordinates x, y, z in metres; x meets the prime meridian. */
  private static double[] earthCentred(GeoPosition position) {
    double latitude = Math.toRadians(position.latitude());
    double longitude = Math.toRadians(position.longitude());
    double sin = Math.sin(latitude);
    double cos = Math.cos(latitude);
    // radius of curvature in the prime vertical
    double normal = EQUATORIAL_RADIUS / Math.sqrt(1 - ECCENTRICITY_SQUARED * sin * sin);
    double fromAxis = (normal + position.height()) * cos;
    return new double[] {
      fromAxis * Math.cos(longitude),
      fromAxis * Math.sin(longitude),
      (normal * (1 - ECCENTRICITY_SQUARED) + position.height()) * sin
    };
  }
}
