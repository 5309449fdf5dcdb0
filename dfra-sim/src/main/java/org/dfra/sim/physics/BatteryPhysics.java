package org.dfra.sim.physics;

import java.time.Instant;

/** A battery as it is measured at its terminals. */
@FunctionalInterface
public interface BatteryPhysics {

  /**
   * How a battery is.
   *
   * @param voltage volts
   * @param current amperes drawn from it, not negative
   * @param remaining charge left, 0 to 1
   */
  record Charge(double voltage, double current, double remaining) {}

  /** How it is at {@code time}. */
  Charge at(Instant time);
}
