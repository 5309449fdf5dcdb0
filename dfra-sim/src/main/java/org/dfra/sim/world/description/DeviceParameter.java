package org.dfra.sim.world.description;

import org.jspecify.annotations.Nullable;

/**
 * A numeric parameter of a kind of device.
 *
 * @param name in lower_snake_case
 * @param ugvDefault default on a UGV
 * @param uavDefault default on a UAV
 * @param min minimum
 * @param max maximum
 * @param unit its unit; empty for a plain number
 * @param meaning its description, half a sentence
 */
public record DeviceParameter(
    String name,
    double ugvDefault,
    double uavDefault,
    double min,
    double max,
    String unit,
    String meaning) {

  /** Its default. */
  public double defaultFor(VehicleType type) {
    return type == VehicleType.UAV ? uavDefault : ugvDefault;
  }

  /** The error of this value and how to correct it; null if it is valid. */
  public @Nullable String violation(double value) {
    String of = unit.isEmpty() ? "" : " " + unit;
    return value >= min && value <= max
        ? null
        : name + " is " + value + of + "; write a number from " + min + " to " + max + of;
  }
}
