package org.dfra.flow.effector;

import java.time.Instant;
import org.dfra.event.Reading;
import org.dfra.geometry.GeoPosition;
import org.jspecify.annotations.Nullable;

/**
 * The flight state that a flight controller reports.
 *
 * @param measured the time of this, UTC
 * @param phase its phase of flight
 * @param isArmed whether its motors are enabled
 * @param position its position, frame WGS84; null while unknown
 * @param height metres above the take-off position
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

  /** Phase of flight. */
  public enum Phase {
    /** It is on the ground. */
    ON_GROUND,
    /** It climbs from the ground to its take-off height. */
    TAKING_OFF,
    /** It flies or holds its position. */
    IN_AIR,
    /** It descends to land. */
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
