package org.dfra.sim.world.description;

import org.dfra.core.config.Place;

/**
 * Sun, temperature and wind; they do not change.
 *
 * @param temperature of the air, kelvin, 200 to 350
 * @param groundWarming how much warmer than the air the sun has made bare ground, kelvin, −30 to
 *     60; at night it is negative
 * @param sunAzimuth where the sun stands, radians from east, counter-clockwise is +
 * @param sunElevation above the horizon, radians, −π/2 to π/2; below 0 is night
 * @param windSpeed speed, metres per second, 0 to 50
 * @param windTowards where it blows to, radians from east, counter-clockwise is +
 * @param gustSigma σ of how the wind's velocity changes, east and north each, metres per second, 0
 *     to 50
 * @param place where it was written
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
