package org.dfra.drivers.gps.m12;

import java.util.List;

/**
 * {@code @@Bb}: the satellites above the horizon by the almanac. Source: Motorola Oncore user's
 * guides.
 *
 * @param count their number; may exceed the twelve that are listed
 * @param satellites at most twelve of them
 */
public record VisibleSatellites(int count, List<VisibleSatellite> satellites)
    implements M12Message {

  /**
   * Direction of a satellite.
   *
   * @param satellite its number, 1 to 37
   * @param doppler shift of its carrier, hertz
   * @param elevation above the horizon, degrees, 0 to 90
   * @param azimuth from true north, clockwise, degrees, 0 to 360
   * @param health the health bits of the almanac; 0 is healthy
   */
  public record VisibleSatellite(
      int satellite, int doppler, int elevation, int azimuth, int health) {}

  public VisibleSatellites {
    satellites = List.copyOf(satellites);
  }

  @Override
  public String id() {
    return "Bb";
  }
}
