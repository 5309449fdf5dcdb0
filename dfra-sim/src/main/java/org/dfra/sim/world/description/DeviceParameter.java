package org.dfra.sim.world.description;

import org.jspecify.annotations.Nullable;

/**
 * A number that a kind of device can be given.
 *
 * @param name in lower_snake_case
 * @param ugv what it is on a UGV where nothing is written
 * @param uav what it is on a UAV where nothing is written
 * @param lowest that makes sense
 * @param highest that makes sense
 * @param unit of it; empty for a plain number
 * @param meaning what it is, half a sentence
 */
public record DeviceParameter(
    String name,
    double ugv,
    double uav,
    double lowest,
    double highest,
    String unit,
    String meaning) {

  /** What it is where nothing is written. */
  public double standard(VehicleType type) {
    return type == VehicleType.UAV ? uav : ugv;
  }

  /** What is wrong with this value, and what to write; null if nothing is. */
  public @Nullable String complaint(double value) {
    String of = unit.isEmpty() ? "" : " " + unit;
    return value >= lowest && value <= highest
        ? null
        : name + " is " + value + of + "; write a number from " + lowest + " to " + highest + of;
  }
}
