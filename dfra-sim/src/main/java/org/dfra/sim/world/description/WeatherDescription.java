package org.dfra.sim.world.description;

import org.dfra.core.config.Place;

/**
 * Sun, temperature and wind; they do not change.
 *
 * @param temperature of the air, kelvin, 200 to 350
 * @param groundWarming temperature of bare ground in the sun minus that of the air, kelvin, −30 to
 *     60; at night it is negative
 * @param sunAzimuth direction of the sun, radians from east, counter-clockwise is +
 * @param sunElevation above the horizon, radians, −π/2 to π/2; below 0 is night
 * @param windSpeed speed, metres per second, 0 to 50
 * @param windTowards direction to which it blows, radians from east, counter-clockwise is +
 * @param gustSigma σ of the wind's velocity changes, east and north each, metres per second, 0 to
 *     50
 * @param place its source location
 */
public record WeatherDescription(
    double temperature,
    double groundWarming,
    double sunAzimuth,
    double sunElevation,
    double windSpeed,
    double windTowards,
    double gustSigma,
    Place place) {

  /** A sunny afternoon with a breeze. */
  public static final WeatherDescription FAIR =
      new WeatherDescription(293.15, 10, -2.4, 0.8, 2, 0, 0.8, Place.CODE);
}
