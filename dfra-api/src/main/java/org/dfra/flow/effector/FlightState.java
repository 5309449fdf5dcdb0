package org.dfra.flow.effector;

import java.time.Instant;
import org.dfra.event.Reading;
import org.dfra.geometry.GeoPosition;
import org.jspecify.annotations.Nullable;

/**
 * How a flight controller flies, as it tells.
 *
 * @param measured the time of this, UTC
 * @param phase what it does
 * @param isArmed whether its motors may turn
 * @param position where it is, frame WGS84; null while it does not know
 * @param height metres above where it took off
 * @param heading of its nose in degrees, 0 to less than 360, 0 is true north, clockwise is +
 * @param speed over ground, metres per second
 * @param climb upwards, metres per second, up is +
 */
public record FlightState(
    Instant measured,
    Phase phase,
    boolean isArmed,
    @Nullable GeoPosition position,
    double height,
    double heading,
    double speed,
    double climb)
    implements Reading {

  /** What it does. */
  public enum Phase {
    /** It stands. */
    ON_GROUND,
    /** It rises from the ground to its take-off height. */
    TAKING_OFF,
    /** It flies or holds its place. */
    IN_AIR,
    /** It goes down. */
    LANDING
  }

  public FlightState {
    if (!(heading >= 0 && heading < 360)) {
      throw new IllegalArgumentException("heading " + heading + "° is outside 0° to 360°");
    }
    if (!(speed >= 0)) {
      throw new IllegalArgumentException("speed " + speed + " m/s is not ≥ 0");
    }
  }
}
