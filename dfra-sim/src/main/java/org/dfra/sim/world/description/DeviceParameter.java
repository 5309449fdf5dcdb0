package org.dfra.sim.world.description;

import org.jspecify.annotations.Nullable;

/**
 * A number that a kind of device can be given.
 *
 * @param name in lower_snake_case
 * @param ugvDefault what it is on a UGV where nothing is written
 * @param uavDefault what it is on a UAV where nothing is written
 * @param min that makes sense
 * @param max that makes sense
 * @param unit of it; empty for a plain number
 * @param meaning what it is, half a sentence
 */
public record DeviceParameter(
    String name,
    double ugvDefault,
    double uavDefault,
    double min,
    double max,
    String unit,
    String meaning) {

  /** What it is where nothing is written. */
  public double defaultFor(VehicleType type) {
    return type == VehicleType.UAV ? uavDefault : ugvDefault;
  }

  /** What is wrong with this value, and what to write; null if nothing is. */
  public @Nullable String violation(double value) {
    String of = unit.isEmpty() ? "" : " " + unit;
    return value >= min && value <= max
        ? null
        : name + " is " + value + of + "; write a number from " + min + " to " + max + of;
  }
}
