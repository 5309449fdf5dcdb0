package org.dfra.behaviors.fuzzy;

import java.util.List;

/**
 * An input or output of a fuzzy system.
 *
 * @param name its name
 * @param low lower end of its range, in its own unit
 * @param high upper end of its range
 * @param terms its linguistic terms, in the order in which rules number them from 1
 */
public record Variable(String name, double low, double high, List<Term> terms) {

  public Variable {
    terms = List.copyOf(terms);
    if (!(low <= high) || Double.isInfinite(low) || Double.isInfinite(high)) {
      throw new IllegalArgumentException(
          "the range of " + name + " wants low ≤ high, not " + low + " and " + high);
    }
  }

  /** The middle of its range. */
  public double middle() {
    return (low + high) / 2;
  }
}
