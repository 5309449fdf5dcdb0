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
public record Variable(String name, double low, double high, List<Variable.Term> terms) {

  public Variable {
    terms = List.copyOf(terms);
    if (!(low <= high) || Double.isInfinite(low) || Double.isInfinite(high)) {
      throw new IllegalArgumentException(
          "the range of " + name + " requires low ≤ high, not " + low + " and " + high);
    }
  }

  /** The middle of its range. */
  public double middle() {
    return (low + high) / 2;
  }

  /**
   * A linguistic term of a variable, such as {@code close}.
   *
   * @param name its name; several terms of a variable may share it
   * @param function its meaning
   */
  public record Term(String name, TermFunction function) {}

  /**
   * The meaning of a term: a fuzzy set, or in a Sugeno system's output a function of the inputs.
   */
  public sealed interface TermFunction permits MembershipFunction, LinearFunction {

    /** The name of its type in a {@code .fis} file. */
    String fisName();

    /** Its parameters, in the order of a {@code .fis} file. */
    List<Double> parameters();
  }
}
