package org.dfra.behaviors.fuzzy;

import java.util.Arrays;
import java.util.List;
import org.dfra.behaviors.fuzzy.Variable.TermFunction;
import org.jspecify.annotations.Nullable;

/** The consequent of a Sugeno rule: a constant, or a weighted sum of the inputs. Immutable. */
public final class LinearFunction implements TermFunction {

  /** The type's name of a constant. */
  public static final String CONSTANT = "constant";

  /** The type's name of a weighted sum. */
  public static final String LINEAR = "linear";

  private final boolean constant;
  private final double[] parameters;

  private LinearFunction(boolean constant, List<Double> parameters) {
    this.constant = constant;
    this.parameters = parameters.stream().mapToDouble(each -> each + 0.0).toArray(); // −0 is 0
    if (!Arrays.stream(this.parameters).allMatch(Double::isFinite)) {
      throw new IllegalArgumentException(fisName() + " takes finite numbers, not " + parameters);
    }
  }

  /** A constant. */
  public static LinearFunction constant(double value) {
    return new LinearFunction(true, List.of(value));
  }

  /**
   * A weighted sum.
   *
   * @param parameters a weight for each input, then the constant term
   */
  public static LinearFunction linear(List<Double> parameters) {
    if (parameters.isEmpty()) {
      throw new IllegalArgumentException(
          "linear needs a weight for each input and a constant, but the list is empty");
    }
    return new LinearFunction(false, parameters);
  }

  /** Whether it is a constant. */
  public boolean isConstant() {
    return constant;
  }

  @Override
  public String fisName() {
    return constant ? CONSTANT : LINEAR;
  }

  @Override
  public List<Double> parameters() {
    return Arrays.stream(parameters).boxed().toList();
  }

  /**
   * Its value.
   *
   * @param inputs one per weight; ignored by a constant
   */
  public double at(double[] inputs) {
    double sum = 0;
    int last = parameters.length - 1;
    for (int i = 0; i < last; i++) {
      sum += parameters[i] * inputs[i];
    }
    return sum + parameters[last];
  }

  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof LinearFunction that
        && constant == that.constant
        && Arrays.equals(parameters, that.parameters);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(parameters);
  }

  @Override
  public String toString() {
    return fisName() + parameters();
  }
}
