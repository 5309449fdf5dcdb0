package org.dfra.persona;

import java.time.Instant;
import java.util.Objects;
import org.dfra.geometry.GeoPosition;

/**
 * The approximate recent position of a module, so that clients can query for near modules. For
 * current values, query the module.
 *
 * @param latitude WGS84 latitude in degrees, north is +
 * @param longitude WGS84 longitude in degrees, east is +
 * @param height height above the WGS84 ellipsoid in metres
 * @param measured time of the measurement, UTC
 */
public record LocationAttributes(double latitude, double longitude, double height, Instant measured)
    implements Attributes {

  public LocationAttributes {
    new GeoPosition(latitude, longitude, height); // validates all three
    measured = Objects.requireNonNull(AttributeValidation.truncatedToMillis(measured));
  }

  /** The place of a measurement. */
  public LocationAttributes(GeoPosition position, Instant measured) {
    this(position.latitude(), position.longitude(), position.height(), measured);
  }

  /** The position, frame WGS84. */
  public GeoPosition position() {
    return new GeoPosition(latitude, longitude, height);
  }
}
