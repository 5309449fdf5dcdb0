package org.dfra.persona;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The reading type, rates and requirements of a sensor.
 *
 * @param reading name of the type of its readings, e.g. {@code GpsFix}
 * @param modes names of its operating modes, sorted
 * @param minRate lowest configurable update rate, in hertz
 * @param maxRate highest configurable update rate, in hertz
 * @param power electric power it draws, in watts; null if not known
 * @param preconditions required conditions of the environment, a sentence each, sorted
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
