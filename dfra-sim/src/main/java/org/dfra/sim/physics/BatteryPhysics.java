package org.dfra.sim.physics;

import java.time.Instant;

/** A battery as it is measured at its terminals. */
@FunctionalInterface
public interface BatteryPhysics {

  /**
   * The state of a battery.
   *
   * @param voltage volts
   * @param current amperes drawn from it, not negative
   * @param remaining charge left, 0 to 1
   */
  record Charge(double voltage, double current, double remaining) {}

  /** Its state at {@code time}. */
  Charge at(Instant time);
}
