package org.dfra.persona;

import org.jspecify.annotations.Nullable;

/**
 * What a flight controller is and how its craft flies.
 *
 * @param autopilot its software, as it names it; null while it has not told
 * @param vehicleType sort of craft, e.g. {@code quadrotor}; null while it has not told
 * @param maxSpeed over ground, metres per second
 * @param maxHeight it may fly above where it took off, metres
 */
public record FlightAttributes(
    @Nullable String autopilot, @Nullable String vehicleType, double maxSpeed, double maxHeight)
    implements Attributes {

  public FlightAttributes {
    AttributeValidation.requirePositive("speed", maxSpeed, "m/s");
    AttributeValidation.requirePositive("height", maxHeight, "m");
  }
}
