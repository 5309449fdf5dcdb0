package org.dfra.flow.sensor;

import java.time.Instant;
import org.dfra.event.Reading;
import org.jspecify.annotations.Nullable;

/**
 * The state of a battery.
 *
 * @param measured time of the measurement, UTC
 * @param voltage at its terminals, volts
 * @param current drawn from it, amperes; negative while it is charged; null if not measured
 * @param remaining charge left, 0 is empty, 1 is full; null if not known
 * @param isEstimated whether {@code remaining} was estimated from the voltage alone
 */
public record BatteryState(
    Instant measured,
    double voltage,
    @Nullable Double current,
    @Nullable Double remaining,
    boolean isEstimated)
    implements Reading {

  public BatteryState {
    if (!(voltage >= 0 && Double.isFinite(voltage))) {
      throw new IllegalArgumentException("voltage " + voltage + " V is not ≥ 0");
    }
    if (remaining != null && !(remaining >= 0 && remaining <= 1)) {
      throw new IllegalArgumentException("remaining charge " + remaining + " is outside 0 to 1");
    }
  }
}
