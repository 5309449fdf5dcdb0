package org.dfra.module;

import java.io.Serializable;

/**
 * What the environment must be like for a module to work.
 *
 * @param quantity what of the environment, e.g. {@code temperature}
 * @param min the least value, in {@code unit}
 * @param max the greatest value, in {@code unit}
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
