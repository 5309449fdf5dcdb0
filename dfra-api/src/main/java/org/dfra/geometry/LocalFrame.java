package org.dfra.geometry;

/**
 * The local east-north-up frame of a datum on the WGS84 ellipsoid: geodetic coordinates to
 * earth-centred ones (ECEF), minus the datum's, rotated into the datum's horizontal plane. Exact at
 * any distance. Source: NIMA TR8350.2, WGS84 parameters; the formulas are textbook geodesy.
 *
 * <p>Both directions agree with GeographicLib to 0.1 µm, also near the poles and at the
 * antimeridian, as {@code GeodesyTest} checks.
 *
 * <p>Immutable; constructing it costs one conversion of the datum. Its arithmetic gives the same
 * bits on every machine.
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
    this.sinLatitude = StrictMath.sin(latitude);
    this.cosLatitude = StrictMath.cos(latitude);
    this.sinLongitude = StrictMath.sin(longitude);
    this.cosLongitude = StrictMath.cos(longitude);
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

  /**
   * The position on the earth of one in this frame: the inverse of {@link #toLocal}, to 20 nm near
   * the ground. Two iterations of Bowring's method. Source: B. R. Bowring, "Transformation from
   * spatial to geographical coordinates", Survey Review 23 (1976).
   */
  public GeoPosition toGeo(LocalPosition position) {
    double outward = cosLatitude * position.up() - sinLatitude * position.north();
    double x = origin[0] + cosLongitude * outward - sinLongitude * position.east();
    double y = origin[1] + sinLongitude * outward + cosLongitude * position.east();
    double z = origin[2] + sinLatitude * position.up() + cosLatitude * position.north();
    double fromAxis = Math.sqrt(x * x + y * y);
    double polarRadius = EQUATORIAL_RADIUS * (1 - FLATTENING);
    double second = ECCENTRICITY_SQUARED / (1 - ECCENTRICITY_SQUARED);
    double reduced = StrictMath.atan2(z, fromAxis * (1 - FLATTENING));
    double latitude = 0;
    for (int i = 0; i < 2; i++) {
      double sin = StrictMath.sin(reduced);
      double cos = StrictMath.cos(reduced);
      latitude =
          StrictMath.atan2(
              z + second * polarRadius * sin * sin * sin,
              fromAxis - ECCENTRICITY_SQUARED * EQUATORIAL_RADIUS * cos * cos * cos);
      reduced =
          StrictMath.atan2((1 - FLATTENING) * StrictMath.sin(latitude), StrictMath.cos(latitude));
    }
    double sin = StrictMath.sin(latitude);
    double height =
        fromAxis * StrictMath.cos(latitude)
            + z * sin
            - EQUATORIAL_RADIUS * Math.sqrt(1 - ECCENTRICITY_SQUARED * sin * sin);
    return new GeoPosition(
        Math.toDegrees(latitude), Math.toDegrees(StrictMath.atan2(y, x)), height);
  }

  /** Earth-centred, earth-fixed coordinates x, y, z in metres; x meets the prime meridian. */
  private static double[] earthCentred(GeoPosition position) {
    double latitude = Math.toRadians(position.latitude());
    double longitude = Math.toRadians(position.longitude());
    double sin = StrictMath.sin(latitude);
    double cos = StrictMath.cos(latitude);
    // radius of curvature in the prime vertical
    double normal = EQUATORIAL_RADIUS / Math.sqrt(1 - ECCENTRICITY_SQUARED * sin * sin);
    double fromAxis = (normal + position.height()) * cos;
    return new double[] {
      fromAxis * StrictMath.cos(longitude),
      fromAxis * StrictMath.sin(longitude),
      (normal * (1 - ECCENTRICITY_SQUARED) + position.height()) * sin
    };
  }
}
