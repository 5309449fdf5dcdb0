package org.dfra.persona;

import org.jspecify.annotations.Nullable;

/**
 * The type of a flight controller and the limits of its vehicle.
 *
 * @param autopilot its software, as it reports it; null until reported
 * @param vehicleType type of vehicle, e.g. {@code quadrotor}; null until reported
 * @param maxSpeed over ground, metres per second
 * @param maxHeight maximum height above the take-off position, metres
 */
public record FlightAttributes(
    @Nullable String autopilot, @Nullable String vehicleType, double maxSpeed, double maxHeight)
    implements Attributes {

  public FlightAttributes {
    AttributeValidation.requirePositive("speed", maxSpeed, "m/s");
    AttributeValidation.requirePositive("height", maxHeight, "m");
  }
}
