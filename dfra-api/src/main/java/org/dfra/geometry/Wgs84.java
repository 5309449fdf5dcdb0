package org.dfra.geometry;

/**
 * The WGS84 ellipsoid: geodetic coordinates to earth-centred, earth-fixed ones (ECEF) and back. In
 * ECEF, x meets the prime meridian and z the north pole; metres. Source: NIMA TR8350.2, WGS84
 * parameters; the formulas are textbook geodesy. The arithmetic gives the same bits on every
 * machine.
 */
public final class Wgs84 {

  /** Equatorial radius, metres. */
  public static final double EQUATORIAL_RADIUS = 6_378_137.0;

  /** Flattening. */
  public static final double FLATTENING = 1 / 298.257223563;

  private static final double ECCENTRICITY_SQUARED = FLATTENING * (2 - FLATTENING);

  private Wgs84() {}

  /**
   * Radius of curvature in the prime vertical, metres: of the ellipsoid along a parallel.
   *
   * @param latitude geodetic, degrees
   */
  public static double primeVerticalRadius(double latitude) {
    return primeVerticalRadiusOfSine(StrictMath.sin(Math.toRadians(latitude)));
  }

  /**
   * Radius of curvature along the meridian, metres.
   *
   * @param latitude geodetic, degrees
   */
  public static double meridianRadius(double latitude) {
    double sin = StrictMath.sin(Math.toRadians(latitude));
    return primeVerticalRadiusOfSine(sin)
        * (1 - ECCENTRICITY_SQUARED)
        / (1 - ECCENTRICITY_SQUARED * sin * sin);
  }

  private static double primeVerticalRadiusOfSine(double sinLatitude) {
    return EQUATORIAL_RADIUS / Math.sqrt(1 - ECCENTRICITY_SQUARED * sinLatitude * sinLatitude);
  }

  /**
   * Earth-centred x, y, z in metres.
   *
   * @param latitude geodetic, degrees
   * @param longitude degrees
   * @param height above the ellipsoid, metres
   */
  static double[] earthCentred(double latitude, double longitude, double height) {
    double phi = Math.toRadians(latitude);
    double lambda = Math.toRadians(longitude);
    double sin = StrictMath.sin(phi);
    double normal = primeVerticalRadiusOfSine(sin);
    double fromAxis = (normal + height) * StrictMath.cos(phi);
    return new double[] {
      fromAxis * StrictMath.cos(lambda),
      fromAxis * StrictMath.sin(lambda),
      (normal * (1 - ECCENTRICITY_SQUARED) + height) * sin
    };
  }

  /**
   * The position with these earth-centred coordinates in metres: the inverse of {@link
   * #earthCentred}, to 20 nm near the ground. Two iterations of Bowring's method. Source: B. R.
   * Bowring, "Transformation from spatial to geographical coordinates", Survey Review 23 (1976).
   */
  static GeoPosition geodetic(double x, double y, double z) {
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
}
