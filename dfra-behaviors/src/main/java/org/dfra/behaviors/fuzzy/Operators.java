package org.dfra.behaviors.fuzzy;

import java.util.Locale;
import java.util.function.DoubleBinaryOperator;

/**
 * How a fuzzy system reckons.
 *
 * @param and joins antecedents that must all hold
 * @param or joins antecedents of which one must hold
 * @param implication cuts or scales a rule's consequent by its firing strength; Mamdani only
 * @param aggregation puts the rules' consequents together; Mamdani only
 * @param defuzzification makes a number of the result
 */
public record Operators(
    And and,
    Or or,
    Implication implication,
    Aggregation aggregation,
    Defuzzification defuzzification) {

  /** MATLAB's for a new Mamdani system: min, max, min, max, centroid. */
  public static final Operators MAMDANI =
      new Operators(And.MIN, Or.MAX, Implication.MIN, Aggregation.MAX, Defuzzification.CENTROID);

  /** MATLAB's for a new Sugeno system: prod, probor, prod, sum, wtaver. */
  public static final Operators SUGENO =
      new Operators(And.PROD, Or.PROBOR, Implication.PROD, Aggregation.SUM, Defuzzification.WTAVER);

  /** Joins what must all hold. */
  public enum And {
    /** The least. */
    MIN(Math::min),
    /** The product. */
    PROD(Operators::product);

    private final DoubleBinaryOperator operator;

    And(DoubleBinaryOperator operator) {
      this.operator = operator;
    }

    double of(double one, double other) {
      return operator.applyAsDouble(one, other);
    }
  }

  /** Joins what of which one must hold. */
  public enum Or {
    /** The greatest. */
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

  /** Applies a firing strength, the first, to a membership of a consequent. */
  public enum Implication {
    /** Cuts it off. */
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

  /** Puts consequents together. */
  public enum Aggregation {
    /** The greatest. */
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

  /** Makes a number of the result. */
  public enum Defuzzification {
    /** Centre of gravity of the aggregated set. */
    CENTROID,
    /** Where its area is halved. */
    BISECTOR,
    /** Mean of the places where it is highest. */
    MOM,
    /** That of these places whose amount is smallest. */
    SOM,
    /** That of these places whose amount is largest. */
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

  /** A method's name in a {@code .fis} file. */
  static String fisName(Enum<?> method) {
    return method.name().toLowerCase(Locale.ROOT);
  }
}
