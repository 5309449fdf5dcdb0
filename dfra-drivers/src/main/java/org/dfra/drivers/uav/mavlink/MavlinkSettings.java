package org.dfra.drivers.uav.mavlink;

import org.dfra.core.config.Parameters;
import org.dfra.drivers.link.BackOff;
import org.dfra.drivers.link.LinkSettings;

/**
 * What the modules that share a link have to agree on.
 *
 * @param link its URL as written
 * @param vehicle the number of the vehicle, 1 to 255; 0 is the first one heard
 * @param groundStation the number that we go by, 1 to 255
 * @param backOff how long to wait before a lost link is opened again
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
