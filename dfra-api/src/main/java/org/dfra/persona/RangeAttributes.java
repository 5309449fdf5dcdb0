package org.dfra.persona;

/**
 * The range, field of view and accuracy of a range sensor.
 *
 * @param minRange minimum measurable distance, metres
 * @param maxRange maximum measurable distance, metres
 * @param fieldOfView angle from its first beam to its last, radians
 * @param resolution angle from beam to beam, radians
 * @param accuracy of a distance, one sigma, metres
 */
public record RangeAttributes(
    double minRange, double maxRange, double fieldOfView, double resolution, double accuracy)
    implements Attributes {

  public RangeAttributes {
    if (!(minRange >= 0 && minRange < maxRange && Double.isFinite(maxRange))) {
      throw new IllegalArgumentException(
          "distances from " + minRange + " m to " + maxRange + " m are no range");
    }
    AttributeValidation.requirePositive("field of view", fieldOfView, "rad");
    AttributeValidation.requirePositive("resolution", resolution, "rad");
    AttributeValidation.requirePositive("accuracy", accuracy, "m");
  }
}
