package org.dfra.flow.sensor;

import java.io.Serial;
import java.time.Instant;
import org.dfra.event.Reading;

/**
 * The angular rate that a gyro measures.
 *
 * @param measured time of the measurement, UTC
 * @param frame name of the gyro's frame, e.g. {@code atrv1/gyro}
 * @param rate about z of that frame, radians per second, to the left is +
 */
public record AngularRate(Instant measured, String frame, double rate) implements Reading {

  public AngularRate {
    if (frame.isBlank()) {
      throw new IllegalArgumentException("an angular rate names no frame");
    }
    if (!Double.isFinite(rate)) {
      throw new IllegalArgumentException("angular rate " + rate + " rad/s is not finite");
    }
  }

  @Serial
  private Object writeReplace() {
    return SensorForm.of(this);
  }
}
