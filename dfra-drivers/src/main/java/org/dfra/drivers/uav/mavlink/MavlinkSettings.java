package org.dfra.drivers.uav.mavlink;

import org.dfra.core.config.Parameters;
import org.dfra.drivers.link.BackOff;
import org.dfra.drivers.link.LinkSettings;

/**
 * The settings that must be the same in all modules that share a link.
 *
 * @param link its URL as configured
 * @param vehicle the number of the vehicle, 1 to 255; 0 is the first one received
 * @param groundStation system ID of this ground station, 1 to 255
 * @param backOff how long to wait before a lost link is reopened
 */
record MavlinkSettings(String link, int vehicle, int groundStation, BackOff backOff) {

  /**
   * Reads {@code link}, {@code vehicle}, {@code ground_station}, {@code reopen_first} and {@code
   * reopen_longest}.
   *
   * @throws org.dfra.core.config.ConfigurationException if one is missing or wrong
   */
  static MavlinkSettings of(Parameters parameters) {
    return new MavlinkSettings(
        LinkSettings.address(parameters).toString(),
        whole(parameters, "vehicle", 0, 0),
        whole(parameters, "ground_station", 255, 1),
        LinkSettings.backOff(parameters));
  }

  private static int whole(Parameters parameters, String name, int fallback, int min) {
    double number = parameters.number(name, fallback, min, 255);
    if (number != Math.rint(number)) {
      throw parameters.fault(name, "a whole number from " + min + " to 255", null);
    }
    return (int) number;
  }
}
