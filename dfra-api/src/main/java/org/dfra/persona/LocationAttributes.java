package org.dfra.persona;

import java.time.Instant;
import java.util.Objects;
import org.dfra.geometry.GeoPosition;

/**
 * Roughly where on the earth a module was not long ago, so that others can ask for what is near
 * them. Who needs to know exactly asks the module itself.
 *
 * @param latitude WGS84 latitude in degrees, north is +
 * @param longitude WGS84 longitude in degrees, east is +
 * @param height height above the WGS84 ellipsoid in metres
 * @param measured when it was there, UTC
 */
public record LocationAttributes(double latitude, double longitude, double height, Instant measured)
    implements Attributes {

  public LocationAttributes {
    new GeoPosition(latitude, longitude, height); // checks all three
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
