package org.dfra.flow.sensor;

import java.time.Instant;
import org.dfra.event.Reading;
import org.dfra.geometry.GeoPosition;

/**
 * Where a location sensor was.
 *
 * @param position the position, frame WGS84
 * @param frame name of the robot's frame that stood there, e.g. {@code atrv1/gps_front}
 * @param measured when it stood there, UTC
 */
public record LocationReading(GeoPosition position, String frame, Instant measured)
    implements Reading {

  public LocationReading {
    if (frame.isBlank()) {
      throw new IllegalArgumentException("a location reading names no frame");
    }
  }
}
