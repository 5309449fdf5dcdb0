package org.dfra.sim.device;

import java.time.Duration;

/**
 * What kind of Oncore an emulated receiver is, and what it has learned. Immutable.
 *
 * @param channels 8 or 12; one of eight ignores {@code @@Ha}, {@code @@Hb}, {@code @@Hn} and
 *     {@code @@Gd}
 * @param timeToUtc how long after it was started it does not know how far GPS time is ahead of UTC:
 *     a receiver without an almanac learns it within 12.5 minutes. Until then {@code @@Bo} is 0,
 *     and what it reports as UTC is GPS time
 */
public record M12EmulatorOptions(int channels, Duration timeToUtc) {

  /** Twelve channels, and an almanac from before. */
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
