package org.dfra.behaviors.fuzzy;

import org.dfra.behaviors.fuzzy.FuzzySystem.ToolboxCompatibility;
import org.dfra.behaviors.fuzzy.Operators.Defuzzification;

/** Defuzzifies a set sampled on a grid. */
final class Defuzzifier {

  private final Defuzzification method;
  private final ToolboxCompatibility engine;

  Defuzzifier(Defuzzification method, ToolboxCompatibility engine) {
    this.method = method;
    this.engine = engine;
  }

  /**
   * The crisp value.
   *
   * @param x the grid, in ascending order
   * @param set membership of each of its points
   * @param middle result where all memberships are 0
   */
  double defuzzify(double[] x, double[] set, double middle) {
    double area = 0;
    for (double each : set) {
      area += each;
    }
    if (area == 0) {
      return engine == ToolboxCompatibility.MATLAB ? middle : Double.NaN;
    }
    return switch (method) {
      case CENTROID ->
          engine == ToolboxCompatibility.MATLAB ? centroid(x, set, area) : trapezoidal(x, set);
      case BISECTOR -> bisector(x, set, area);
      case MOM -> meanOfMaximum(x, set);
      case SOM -> extreme(x, set, true);
      case LOM -> extreme(x, set, false);
      case WTAVER, WTSUM -> throw new IllegalStateException(method + " is for Sugeno systems only");
    };
  }

  private static double centroid(double[] x, double[] set, double area) {
    double moment = 0;
    for (int i = 0; i < x.length; i++) {
      moment += set[i] * x[i];
    }
    return moment / area;
  }

  private static double trapezoidal(double[] x, double[] set) {
    double area = 0;
    double moment = 0;
    for (int i = 1; i < x.length; i++) {
      double half = (x[i] - x[i - 1]) / 2;
      area += half * (set[i] + set[i - 1]);
      moment += half * (set[i] * x[i] + set[i - 1] * x[i - 1]);
    }
    return moment / area;
  }

  private static double bisector(double[] x, double[] set, double area) {
    double so = 0;
    int i = -1;
    while (so < area / 2) {
      so += set[++i];
    }
    return x[Math.max(0, i)];
  }

  private static double highest(double[] set) {
    double highest = 0;
    for (double each : set) {
      highest = Math.max(highest, each);
    }
    return highest;
  }

  private static double meanOfMaximum(double[] x, double[] set) {
    double highest = highest(set);
    double sum = 0;
    int count = 0;
    for (int i = 0; i < x.length; i++) {
      if (set[i] == highest) {
        sum += x[i];
        count++;
      }
    }
    return sum / count;
  }

  private static double extreme(double[] x, double[] set, boolean isSmallest) {
    double highest = highest(set);
    double found = Double.NaN;
    for (int i = 0; i < x.length; i++) {
      boolean isBetter =
          Double.isNaN(found)
              || (isSmallest ? Math.abs(x[i]) < Math.abs(found) : Math.abs(x[i]) > Math.abs(found));
      if (set[i] == highest && isBetter) {
        found = x[i];
      }
    }
    return found;
  }
}
