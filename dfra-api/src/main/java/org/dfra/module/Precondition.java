package org.dfra.module;

import java.io.Serializable;

/**
 * A condition of the environment that a module needs to work.
 *
 * @param quantity the environmental quantity, e.g. {@code temperature}
 * @param min the minimum, in {@code unit}
 * @param max the maximum, in {@code unit}
 * @param unit the unit, e.g. {@code °C}
 */
public record Precondition(String quantity, double min, double max, String unit)
    implements Serializable {

  public Precondition {
    if (!(min <= max)) {
      throw new IllegalArgumentException(
          quantity + " from " + min + " to " + max + " " + unit + " is no range");
    }
  }
}
