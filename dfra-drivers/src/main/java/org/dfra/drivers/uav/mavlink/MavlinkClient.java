package org.dfra.drivers.uav.mavlink;

import java.util.Map;
import org.dfra.drivers.device.SharedLinkClient;

/** A module that shares a {@link MavlinkConnection}. */
interface MavlinkClient extends SharedLinkClient {

  /** Whether it commands the vehicle, which then requires heartbeats. */
  default boolean commands() {
    return false;
  }

  /**
   * The required messages, with their rates in hertz; queried repeatedly, so that a rate can
   * change.
   */
  Map<Integer, Double> messageRates();

  /** The link is open, and this vehicle is on it; from now on its messages are received. */
  void vehicleFound(Vehicle vehicle);

  /** The vehicle's autopilot has sent this message. */
  void messageReceived(MavlinkMessage message);

  /** Called periodically, at intervals of at most some tenths of a second. */
  void periodic();
}
