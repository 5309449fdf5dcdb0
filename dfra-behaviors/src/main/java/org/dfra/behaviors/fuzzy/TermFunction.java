package org.dfra.behaviors.fuzzy;

import java.util.List;

/** The meaning of a term: a fuzzy set, or in a Sugeno system's output a function of the inputs. */
public sealed interface TermFunction permits MembershipFunction, LinearFunction {

  /** The name of its type in a {@code .fis} file. */
  String fisName();

  /** Its parameters, in the order of a {@code .fis} file. */
  List<Double> parameters();
}
