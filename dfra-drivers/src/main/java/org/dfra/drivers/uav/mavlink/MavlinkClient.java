package org.dfra.drivers.uav.mavlink;

import java.util.Map;
import org.dfra.drivers.device.SharedLinkClient;

/** A module that shares a {@link MavlinkConnection}. */
interface MavlinkClient extends SharedLinkClient {

  /** Whether it commands the vehicle, so that the vehicle must hear that it is there. */
  default boolean commands() {
    return false;
  }

  /**
   * The messages it wants, with their rates in hertz; asked again and again, so that a rate can
   * change.
   */
  Map<Integer, Double> messageRates();

  /** The link is open, and this vehicle is on it; from now on it is heard. */
  void vehicleFound(Vehicle vehicle);

  /** The vehicle's autopilot said this. */
  void messageReceived(MavlinkMessage message);

  /** Time has passed, some tenths of a second at the most. */
  void periodic();
}
