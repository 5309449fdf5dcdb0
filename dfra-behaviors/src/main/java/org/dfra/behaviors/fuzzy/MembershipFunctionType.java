package org.dfra.behaviors.fuzzy;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** The shapes of membership functions, each under the name that {@code .fis} files use. */
public enum MembershipFunctionType {
  /** A triangle with feet at a and c and its peak at b; a = b or b = c makes a step. */
  TRIMF("trimf", "a", "b", "c") {
    @Override
    double at(double x, double[] p) {
      double a = p[0];
      double b = p[1];
      double c = p[2];
      if (x == b) {
        return 1;
      } else if (x > a && x < b) {
        return (x - a) / (b - a);
      }
      return x > b && x < c ? (c - x) / (c - b) : 0;
    }

    @Override
    @Nullable String validationError(double[] p) {
      return p[0] <= p[1] && p[1] <= p[2] ? null : "requires a ≤ b ≤ c";
    }
  },
  /** A trapezium that rises from a to b and falls from c to d. */
  TRAPMF("trapmf", "a", "b", "c", "d") {
    @Override
    double at(double x, double[] p) {
      double rising = x >= p[1] ? 1 : x < p[0] ? 0 : (x - p[0]) / (p[1] - p[0]);
      double falling = x <= p[2] ? 1 : x > p[3] ? 0 : (p[3] - x) / (p[3] - p[2]);
      return Math.min(rising, falling);
    }

    @Override
    @Nullable String validationError(double[] p) {
      return p[0] <= p[1] && p[2] <= p[3] ? null : "requires a ≤ b and c ≤ d";
    }
  },
  /** A Gaussian around c. */
  GAUSSMF("gaussmf", "σ", "c") {
    @Override
    double at(double x, double[] p) {
      return gauss(x, p[0], p[1]);
    }

    @Override
    @Nullable String validationError(double[] p) {
      return p[0] != 0 ? null : NO_WIDTH;
    }
  },
  /** Rises as one Gaussian up to c1, falls as another from c2 on. */
  GAUSS2MF("gauss2mf", "σ1", "c1", "σ2", "c2") {
    @Override
    double at(double x, double[] p) {
      double rising = x <= p[1] ? gauss(x, p[0], p[1]) : 1;
      double falling = x >= p[3] ? gauss(x, p[2], p[3]) : 1;
      return rising * falling;
    }

    @Override
    @Nullable String validationError(double[] p) {
      return p[0] != 0 && p[2] != 0 ? null : NO_WIDTH;
    }
  },
  /** A generalised bell around c, half as high at c ± a, steeper the larger b is. */
  GBELLMF("gbellmf", "a", "b", "c") {
    @Override
    double at(double x, double[] p) {
      double distance = (x - p[2]) / p[0];
      double square = distance * distance;
      if (square == 0 && p[1] <= 0) {
        return p[1] == 0 ? 0.5 : 0;
      }
      return 1 / (1 + Math.pow(square, p[1]));
    }

    @Override
    @Nullable String validationError(double[] p) {
      return p[0] != 0 ? null : "requires a ≠ 0";
    }
  },
  /** A sigmoid centred at c; a is its slope; it falls where a is negative. */
  SIGMF("sigmf", "a", "c") {
    @Override
    double at(double x, double[] p) {
      return sigmoid(x, p[0], p[1]);
    }
  },
  /** The absolute difference of two sigmoids. */
  DSIGMF("dsigmf", "a1", "c1", "a2", "c2") {
    @Override
    double at(double x, double[] p) {
      return Math.abs(sigmoid(x, p[0], p[1]) - sigmoid(x, p[2], p[3]));
    }
  },
  /** The product of two sigmoids. */
  PSIGMF("psigmf", "a1", "c1", "a2", "c2") {
    @Override
    double at(double x, double[] p) {
      return sigmoid(x, p[0], p[1]) * sigmoid(x, p[2], p[3]);
    }
  },
  /** Rises from a to b as an S of two parabolas; a step between them where a ≥ b. */
  SMF("smf", "a", "b") {
    @Override
    double at(double x, double[] p) {
      return rising(x, p[0], p[1]);
    }
  },
  /** Falls from a to b as a Z of two parabolas; a step between them where a ≥ b. */
  ZMF("zmf", "a", "b") {
    @Override
    double at(double x, double[] p) {
      return falling(x, p[0], p[1]);
    }
  },
  /** The product of an S from a to b and a Z from c to d. */
  PIMF("pimf", "a", "b", "c", "d") {
    @Override
    double at(double x, double[] p) {
      return rising(x, p[0], p[1]) * falling(x, p[2], p[3]);
    }
  };

  private static final String NO_WIDTH = "requires σ ≠ 0";

  private final String word;
  private final List<String> parameters;

  MembershipFunctionType(String word, String... parameters) {
    this.word = word;
    this.parameters = List.of(parameters);
  }

  /** Its name in a {@code .fis} file. */
  public String fisName() {
    return word;
  }

  /** Names of its parameters, in the order of a {@code .fis} file. */
  public List<String> parameters() {
    return parameters;
  }

  /** The type of that name in a {@code .fis} file. */
  public static Optional<MembershipFunctionType> of(String word) {
    return Arrays.stream(values()).filter(each -> each.word.equals(word)).findFirst();
  }

  /** Membership of x, from 0 to 1. */
  abstract double at(double x, double[] p);

  /** The error of parameters of the right number, or null. */
  @Nullable String validationError(double[] p) {
    return null;
  }

  private static double gauss(double x, double sigma, double centre) {
    double distance = x - centre;
    return Math.exp(-distance * distance / (2 * sigma * sigma));
  }

  private static double sigmoid(double x, double steepness, double centre) {
    return 1 / (1 + Math.exp(-steepness * (x - centre)));
  }

  private static double rising(double x, double a, double b) {
    if (a >= b) {
      return x >= (a + b) / 2 ? 1 : 0;
    } else if (x <= a) {
      return 0;
    } else if (x <= (a + b) / 2) {
      double part = (x - a) / (b - a);
      return 2 * part * part;
    } else if (x <= b) {
      double part = (b - x) / (b - a);
      return 1 - 2 * part * part;
    }
    return 1;
  }

  private static double falling(double x, double a, double b) {
    if (a >= b) {
      return x <= (a + b) / 2 ? 1 : 0;
    }
    return 1 - rising(x, a, b);
  }
}
