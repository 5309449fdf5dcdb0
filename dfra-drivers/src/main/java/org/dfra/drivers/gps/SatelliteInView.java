package org.dfra.drivers.gps;

import org.jspecify.annotations.Nullable;

/**
 * One satellite as a receiver sees it.
 *
 * @param name system and number as RINEX writes them: {@code G14}; G is GPS, R GLONASS, E Galileo,
 *     C BeiDou, J QZSS, I NavIC, S an augmentation satellite
 * @param elevation above the horizon, degrees, −90 to 90; null where it is not told
 * @param azimuth from true north, clockwise, degrees, 0 to 360; null where it is not told
 * @param signal carrier to noise density, dB-Hz; null where it is not tracked
 * @param used whether the position rests on it
 */
public record SatelliteInView(
    String name,
    @Nullable Integer elevation,
    @Nullable Integer azimuth,
    @Nullable Integer signal,
    boolean used) {

  /** Whether the receiver hears it. */
  public boolean isTracked() {
    return signal != null;
  }

  /** {@code G14 41° up, 60° from north, 47 dB-Hz, used}. */
  @Override
  public String toString() {
    return name
        + (elevation == null ? "" : " " + elevation + "° up,")
        + (azimuth == null ? "" : " " + azimuth + "° from north,")
        + (signal == null ? " not heard" : " " + signal + " dB-Hz")
        + (used ? ", used" : "");
  }
}
