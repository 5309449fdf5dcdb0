package org.dfra.persona;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * How a sensor measures.
 *
 * @param reading name of the type of its readings, e.g. {@code GpsFix}
 * @param modes names of its operating modes, sorted
 * @param minRate slowest update rate that it can be set to, in hertz
 * @param maxRate fastest update rate that it can be set to, in hertz
 * @param power electric power it draws, in watts; null if not known
 * @param preconditions what its surroundings must be like, a sentence each, sorted
 */
public record SensorAttributes(
    String reading,
    List<String> modes,
    double minRate,
    double maxRate,
    @Nullable Double power,
    List<String> preconditions)
    implements Attributes {

  public SensorAttributes {
    AttributeValidation.requireText("reading", reading);
    modes = AttributeValidation.sortedDistinct(modes);
    preconditions = AttributeValidation.sortedDistinct(preconditions);
    if (!(minRate >= 0 && minRate <= maxRate && Double.isFinite(maxRate))) {
      throw new IllegalArgumentException(
          "update rates from " + minRate + " Hz to " + maxRate + " Hz are no range");
    }
    AttributeValidation.requireValidPower(power);
  }
}
