package org.dfra.flow.sensor;

import java.time.Instant;
import org.dfra.event.Reading;
import org.dfra.geometry.GeoPosition;

/**
 * The measured position of a location sensor.
 *
 * @param position the position, frame WGS84
 * @param frame name of the sensor's frame, e.g. {@code atrv1/gps_front}
 * @param measured time of the measurement, UTC
 */
public record LocationReading(GeoPosition position, String frame, Instant measured)
    implements Reading {

  public LocationReading {
    if (frame.isBlank()) {
      throw new IllegalArgumentException("a location reading names no frame");
    }
  }
}
