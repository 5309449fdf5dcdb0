package org.dfra.sim.device;

import java.time.Duration;

/**
 * Model of an emulated Oncore, and its initial knowledge of UTC. Immutable.
 *
 * @param channels 8 or 12; one of eight ignores {@code @@Ha}, {@code @@Hb}, {@code @@Hn} and
 *     {@code @@Gd}
 * @param timeToUtc time from its start until it knows the offset of GPS time from UTC: a receiver
 *     without an almanac learns it within 12.5 minutes. Until then {@code @@Bo} is 0, and what it
 *     reports as UTC is GPS time
 */
public record M12EmulatorOptions(int channels, Duration timeToUtc) {

  /** Twelve channels, and a stored almanac. */
  public static final M12EmulatorOptions USUAL = new M12EmulatorOptions(12, Duration.ZERO);

  public M12EmulatorOptions {
    if (channels != 8 && channels != 12) {
      throw new IllegalArgumentException(channels + " channels; an Oncore has 8 or 12");
    }
    if (timeToUtc.isNegative()) {
      throw new IllegalArgumentException("time to UTC " + timeToUtc + " is negative");
    }
  }
}
