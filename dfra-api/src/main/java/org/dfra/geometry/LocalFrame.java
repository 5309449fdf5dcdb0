package org.dfra.geometry;

/**
 * The local east-north-up frame of a datum on the WGS84 ellipsoid: geodetic coordinates to
 * earth-centred ones (ECEF, see {@link Wgs84}), minus the datum's, rotated into the datum's
 * horizontal plane. Exact at any distance.
 *
 * <p>Both directions agree with GeographicLib to 0.1 µm, also near the poles and at the
 * antimeridian, as {@code GeodesyTest} checks.
 *
 * <p>Immutable; constructing it costs one conversion of the datum. Its arithmetic gives the same
 * bits on every machine.
 */
public final class LocalFrame {

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
   * the ground.
   */
  public GeoPosition toGeo(LocalPosition position) {
    double outward = cosLatitude * position.up() - sinLatitude * position.north();
    double x = origin[0] + cosLongitude * outward - sinLongitude * position.east();
    double y = origin[1] + sinLongitude * outward + cosLongitude * position.east();
    double z = origin[2] + sinLatitude * position.up() + cosLatitude * position.north();
    return Wgs84.geodetic(x, y, z);
  }

  private static double[] earthCentred(GeoPosition position) {
    return Wgs84.earthCentred(position.latitude(), position.longitude(), position.height());
  }
}
