package org.dfra.behaviors.fuzzy;

import java.util.Locale;

/**
 * How a fuzzy system reckons.
 *
 * @param and joins antecedents that must all hold
 * @param or joins antecedents of which one must hold
 * @param implication cuts or scales a rule's consequent by its firing strength; Mamdani only
 * @param aggregation puts the rules' consequents together; Mamdani only
 * @param defuzzification makes a number of the result
 */
public record Methods(
    And and,
    Or or,
    Implication implication,
    Aggregation aggregation,
    Defuzzification defuzzification) {

  /** MATLAB's for a new Mamdani system: min, max, min, max, centroid. */
  public static final Methods MAMDANI =
      new Methods(And.MIN, Or.MAX, Implication.MIN, Aggregation.MAX, Defuzzification.CENTROID);

  /** MATLAB's for a new Sugeno system: prod, probor, prod, sum, wtaver. */
  public static final Methods SUGENO =
      new Methods(And.PROD, Or.PROBOR, Implication.PROD, Aggregation.SUM, Defuzzification.WTAVER);

  /** Joins what must all hold. */
  public enum And {
    /** The least. */
    MIN {
      @Override
      double of(double one, double other) {
        return Math.min(one, other);
      }
    },
    /** The product. */
    PROD {
      @Override
      double of(double one, double other) {
        return one * other;
      }
    };

    abstract double of(double one, double other);
  }

  /** Joins what of which one must hold. */
  public enum Or {
    /** The greatest. */
    MAX {
      @Override
      double of(double one, double other) {
        return Math.max(one, other);
      }
    },
    /** The probabilistic or: a + b − a·b. */
    PROBOR {
      @Override
      double of(double one, double other) {
        return one + other - one * other;
      }
    };

    abstract double of(double one, double other);
  }

  /** Applies a firing strength to a consequent. */
  public enum Implication {
    /** Cuts it off. */
    MIN {
      @Override
      double of(double strength, double membership) {
        return Math.min(strength, membership);
      }
    },
    /** Scales it. */
    PROD {
      @Override
      double of(double strength, double membership) {
        return strength * membership;
      }
    };

    abstract double of(double strength, double membership);
  }

  /** Puts consequents together. */
  public enum Aggregation {
    /** The greatest. */
    MAX {
      @Override
      double of(double one, double other) {
        return Math.max(one, other);
      }
    },
    /** The sum. */
    SUM {
      @Override
      double of(double one, double other) {
        return one + other;
      }
    },
    /** The probabilistic or: a + b − a·b. */
    PROBOR {
      @Override
      double of(double one, double other) {
        return one + other - one * other;
      }
    };

    abstract double of(double one, double other);
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
    public boolean isOfSugeno() {
      return this == WTAVER || this == WTSUM;
    }
  }

  /** A method's name in a {@code .fis} file. */
  static String word(Enum<?> method) {
    return method.name().toLowerCase(Locale.ROOT);
  }
}
