package org.dfra.drivers.gps;

import org.jspecify.annotations.Nullable;

/**
 * A satellite in a receiver's view.
 *
 * @param name system and number in RINEX notation: {@code G14}; G is GPS, R GLONASS, E Galileo, C
 *     BeiDou, J QZSS, I NavIC, S an augmentation satellite
 * @param elevation above the horizon, degrees, −90 to 90; null where it is not reported
 * @param azimuth from true north, clockwise, degrees, 0 to 360; null where it is not reported
 * @param signal carrier to noise density, dB-Hz; null where it is not tracked
 * @param used whether it is used for the position
 */
public record SatelliteInView(
    String name,
    @Nullable Integer elevation,
    @Nullable Integer azimuth,
    @Nullable Integer signal,
    boolean used) {

  /** Whether the receiver tracks it. */
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
