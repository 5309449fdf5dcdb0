package org.dfra.behaviors.fuzzy;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import org.dfra.behaviors.fuzzy.Variable.TermFunction;
import org.jspecify.annotations.Nullable;

/** A fuzzy set over the real numbers. Immutable. */
public final class MembershipFunction implements TermFunction {

  private final MembershipFunctionType type;
  private final double[] parameters;

  /**
   * @param parameters of the type, in its order
   * @throws IllegalArgumentException if there are too many or too few, one is not finite, or they
   *     are inconsistent; the message states the rule
   */
  public MembershipFunction(MembershipFunctionType type, List<Double> parameters) {
    this.type = type;
    this.parameters = parameters.stream().mapToDouble(each -> each + 0.0).toArray(); // −0 is 0
    if (this.parameters.length != type.parameters().size()) {
      throw new IllegalArgumentException(
          type.fisName() + " takes the parameters " + type.parameters() + ", not " + parameters);
    }
    if (!Arrays.stream(this.parameters).allMatch(Double::isFinite)) {
      throw new IllegalArgumentException(
          type.fisName() + " takes finite numbers, not " + parameters);
    }
    @Nullable String complaint = type.validationError(this.parameters);
    if (complaint != null) {
      throw new IllegalArgumentException(
          type.fisName() + " " + type.parameters() + " " + complaint + ", not " + parameters);
    }
  }

  /** Its shape. */
  public MembershipFunctionType type() {
    return type;
  }

  @Override
  public String fisName() {
    return type.fisName();
  }

  @Override
  public List<Double> parameters() {
    return Arrays.stream(parameters).boxed().toList();
  }

  /** Membership of x, from 0 to 1. */
  public double at(double x) {
    return type.at(x, parameters);
  }

  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof MembershipFunction that
        && type == that.type
        && Arrays.equals(parameters, that.parameters);
  }

  @Override
  public int hashCode() {
    return Objects.hash(type, Arrays.hashCode(parameters));
  }

  @Override
  public String toString() {
    return fisName() + parameters();
  }
}
