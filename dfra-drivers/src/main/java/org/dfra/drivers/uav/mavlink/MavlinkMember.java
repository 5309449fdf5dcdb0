package org.dfra.drivers.uav.mavlink;

import java.util.Map;
import org.dfra.drivers.device.LineMember;

/** A module that shares a {@link MavlinkConnection}. */
interface MavlinkMember extends LineMember {

  /** Whether it commands the vehicle, so that the vehicle must hear that it is there. */
  default boolean commands() {
    return false;
  }

  /**
   * The messages it wants, with their rates in hertz; asked again and again, so that a rate can
   * change.
   */
  Map<Integer, Double> streams();

  /** The link is open, and this vehicle is on it; from now on it is heard. */
  void found(Vehicle vehicle);

  /** The vehicle's autopilot said this. */
  void heard(MavlinkMessage message);

  /** Time has passed, some tenths of a second at the most. */
  void tend();
}
