package org.dfra.behaviors.fuzzy;

import java.util.Locale;
import java.util.function.DoubleBinaryOperator;

/**
 * Inference operators of a fuzzy system.
 *
 * @param and conjunction of antecedents
 * @param or disjunction of antecedents
 * @param implication clips or scales a rule's consequent by its firing strength; Mamdani only
 * @param aggregation combines the rules' consequents; Mamdani only
 * @param defuzzification converts the result to a crisp value
 */
public record Operators(
    And and,
    Or or,
    Implication implication,
    Aggregation aggregation,
    Defuzzification defuzzification) {

  /** MATLAB's defaults for a Mamdani system: min, max, min, max, centroid. */
  public static final Operators MAMDANI =
      new Operators(And.MIN, Or.MAX, Implication.MIN, Aggregation.MAX, Defuzzification.CENTROID);

  /** MATLAB's defaults for a Sugeno system: prod, probor, prod, sum, wtaver. */
  public static final Operators SUGENO =
      new Operators(And.PROD, Or.PROBOR, Implication.PROD, Aggregation.SUM, Defuzzification.WTAVER);

  /** Conjunction. */
  public enum And {
    /** Minimum. */
    MIN(Math::min),
    /** Product. */
    PROD(Operators::product);

    private final DoubleBinaryOperator operator;

    And(DoubleBinaryOperator operator) {
      this.operator = operator;
    }

    double of(double one, double other) {
      return operator.applyAsDouble(one, other);
    }
  }

  /** Disjunction. */
  public enum Or {
    /** Maximum. */
    MAX(Math::max),
    /** The probabilistic or: a + b − a·b. */
    PROBOR(Operators::probabilisticOr);

    private final DoubleBinaryOperator operator;

    Or(DoubleBinaryOperator operator) {
      this.operator = operator;
    }

    double of(double one, double other) {
      return operator.applyAsDouble(one, other);
    }
  }

  /** Applies a firing strength, the first argument, to a membership of a consequent. */
  public enum Implication {
    /** Clips it. */
    MIN(Math::min),
    /** Scales it. */
    PROD(Operators::product);

    private final DoubleBinaryOperator operator;

    Implication(DoubleBinaryOperator operator) {
      this.operator = operator;
    }

    double of(double one, double other) {
      return operator.applyAsDouble(one, other);
    }
  }

  /** Aggregation of consequents. */
  public enum Aggregation {
    /** Maximum. */
    MAX(Math::max),
    /** The sum. */
    SUM(Double::sum),
    /** The probabilistic or: a + b − a·b. */
    PROBOR(Operators::probabilisticOr);

    private final DoubleBinaryOperator operator;

    Aggregation(DoubleBinaryOperator operator) {
      this.operator = operator;
    }

    double of(double one, double other) {
      return operator.applyAsDouble(one, other);
    }
  }

  /** Defuzzification. */
  public enum Defuzzification {
    /** Centre of gravity of the aggregated set. */
    CENTROID,
    /** Bisector of its area. */
    BISECTOR,
    /** Mean of maximum. */
    MOM,
    /** Smallest of maximum, by absolute value. */
    SOM,
    /** Largest of maximum, by absolute value. */
    LOM,
    /** Mean of the rules' results, weighted by their firing strengths; Sugeno only. */
    WTAVER,
    /** Sum of the rules' results, weighted by their firing strengths; Sugeno only. */
    WTSUM;

    /** Whether Sugeno systems use it; Mamdani systems use the others. */
    public boolean isSugenoOnly() {
      return this == WTAVER || this == WTSUM;
    }
  }

  private static double product(double one, double other) {
    return one * other;
  }

  private static double probabilisticOr(double one, double other) {
    return one + other - one * other;
  }

  /** An operator's name in a {@code .fis} file. */
  static String fisName(Enum<?> method) {
    return method.name().toLowerCase(Locale.ROOT);
  }
}
