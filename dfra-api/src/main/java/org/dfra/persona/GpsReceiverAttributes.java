package org.dfra.persona;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The identity and capabilities of a satellite positioning receiver. Values not reported are null.
 *
 * @param model model, as the receiver reports it
 * @param serialNumber its serial number
 * @param softwarePart part number of its software
 * @param softwareVersion version of its software
 * @param channels how many satellites it can track at once
 * @param fixModes the solutions it can compute, sorted: {@code 2D}, {@code 3D}
 */
public record GpsReceiverAttributes(
    @Nullable String model,
    @Nullable String serialNumber,
    @Nullable String softwarePart,
    @Nullable String softwareVersion,
    @Nullable Integer channels,
    List<String> fixModes)
    implements Attributes {

  public GpsReceiverAttributes {
    fixModes = AttributeValidation.sortedDistinct(fixModes);
    if (channels != null && channels < 1) {
      throw new IllegalArgumentException("a receiver with " + channels + " channels");
    }
  }
}
