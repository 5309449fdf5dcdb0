package org.dfra.flow.sensor;

import java.io.Serial;
import java.time.Instant;
import org.dfra.event.Reading;

/**
 * A robot's pose and velocity from its wheel encoders.
 *
 * @param measured time of the count, UTC
 * @param frame name of the pose's frame, e.g. {@code atrv1/odom}: its origin is where the sensor
 *     began to count; the pose stays continuous when a controller resets its counters
 * @param childFrame name of the moving frame, e.g. {@code atrv1/base_link}
 * @param x metres forward of the origin
 * @param y metres to the left of the origin
 * @param yaw rotation since the beginning in radians, to the left is +, not wrapped
 * @param speed along the child's x, metres per second, forward is +
 * @param yawRate about z, radians per second, to the left is +
 */
public record Odometry(
    Instant measured,
    String frame,
    String childFrame,
    double x,
    double y,
    double yaw,
    double speed,
    double yawRate)
    implements Reading {

  public Odometry {
    if (frame.isBlank() || childFrame.isBlank()) {
      throw new IllegalArgumentException("odometry names no frame");
    }
    if (!Double.isFinite(x + y + yaw + speed + yawRate)) {
      throw new IllegalArgumentException(
          "odometry (" + x + " m, " + y + " m, " + yaw + " rad) is not finite");
    }
  }

  @Serial
  private Object writeReplace() {
    return SensorForm.of(this);
  }
}
