package org.dfra.module;

import java.io.Serializable;

/**
 * What the environment must be like for a module to work.
 *
 * @param quantity what of the environment, e.g. {@code temperature}
 * @param least the least value, in {@code unit}
 * @param most the greatest value, in {@code unit}
 * @param unit the unit, e.g. {@code °C}
 */
public record Precondition(String quantity, double least, double most, String unit)
    implements Serializable {

  public Precondition {
    if (!(least <= most)) {
      throw new IllegalArgumentException(
          quantity + " from " + least + " to " + most + " " + unit + " is no range");
    }
  }
}
