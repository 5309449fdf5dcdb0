package org.dfra.behaviors.fuzzy;

import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.dfra.behaviors.fuzzy.FuzzySystem.Rule;
import org.dfra.behaviors.fuzzy.Variable.Term;

/**
 * Fuzzy inference written down as its definition says, point by point and rule by rule, with
 * membership functions of its own. Slow, and nothing of it is shared with what it judges.
 */
final class BruteForce {

  private static final int LAST = 100;

  /** Closer than this part of them, rounding decides which of two is higher. */
  private static final double NEAR = 1e-11;

  private final FuzzySystem system;
  private final double[] inputs;

  private BruteForce(FuzzySystem system, double[] inputs) {
    this.system = system;
    this.inputs = inputs;
  }

  /**
   * Where an output must lie. A centroid is one number. The other methods jump from one point of
   * the grid to another where two are equally good, so there rounding may decide.
   */
  record Answer(double least, double most) {

    boolean admits(double value) {
      return value >= least - 1e-9 && value <= most + 1e-9;
    }

    static Answer of(double value) {
      return new Answer(value, value);
    }
  }

  static List<Answer> matlab(FuzzySystem system, double[] inputs) {
    BruteForce force = new BruteForce(system, inputs);
    return IntStream.range(0, system.outputs().size())
        .mapToObj(
            output ->
                system.type() == FuzzySystem.Type.SUGENO
                    ? Answer.of(force.sugeno(output))
                    : force.mamdani(output))
        .toList();
  }

  private double strength(Rule rule) {
    boolean isAnd = rule.connective() == Rule.Connective.AND;
    String method = isAnd ? system.operators().and().name() : system.operators().or().name();
    double[] named =
        IntStream.range(0, inputs.length)
            .filter(i -> rule.antecedents().get(i) != 0)
            .mapToDouble(
                i -> membership(system.inputs().get(i), rule.antecedents().get(i), inputs[i]))
            .toArray();
    double joined = isAnd ? 1 : 0;
    for (double each : named) {
      joined = operator(method).applyAsDouble(joined, each);
    }
    return joined * rule.weight();
  }

  private static DoubleBinaryOperator operator(String method) {
    return switch (method) {
      case "MIN" -> (a, b) -> a < b ? a : b;
      case "MAX" -> (a, b) -> a > b ? a : b;
      case "PROD" -> (a, b) -> a * b;
      case "SUM" -> (a, b) -> a + b;
      case "PROBOR" -> (a, b) -> a + b - a * b;
      default -> throw new IllegalArgumentException(method);
    };
  }

  private double sugeno(int output) {
    Variable variable = system.outputs().get(output);
    double weighted = 0;
    double total = 0;
    for (Rule rule : system.rules()) {
      int term = rule.consequents().get(output);
      if (term != 0) {
        List<Double> p = variable.terms().get(term - 1).function().parameters();
        double value = p.get(p.size() - 1);
        for (int i = 0; i + 1 < p.size(); i++) {
          value += p.get(i) * inputs[i];
        }
        weighted += value * strength(rule);
        total += strength(rule);
      }
    }
    if (system.operators().defuzzification() == Operators.Defuzzification.WTSUM) {
      return weighted;
    }
    return total > 0 ? weighted / total : (variable.low() + variable.high()) / 2;
  }

  private Answer mamdani(int output) {
    Variable variable = system.outputs().get(output);
    double[] x = new double[LAST + 1];
    for (int i = 0; i <= LAST; i++) {
      x[i] = variable.low() + (variable.high() - variable.low()) * i / LAST;
    }
    List<double[]> sets =
        system.rules().stream()
            .filter(rule -> rule.consequents().get(output) != 0)
            .map(rule -> implied(rule, variable, rule.consequents().get(output), x))
            .toList();
    double[] y = new double[LAST + 1];
    for (double[] set : sets) {
      for (int i = 0; i <= LAST; i++) {
        y[i] = operator(system.operators().aggregation().name()).applyAsDouble(y[i], set[i]);
      }
    }
    double area = Arrays.stream(y).sum();
    if (area == 0) {
      return Answer.of((variable.low() + variable.high()) / 2);
    }
    return switch (system.operators().defuzzification()) {
      case CENTROID ->
          Answer.of(IntStream.rangeClosed(0, LAST).mapToDouble(i -> x[i] * y[i]).sum() / area);
      case BISECTOR -> new Answer(half(x, y, area * (1 - NEAR)), half(x, y, area * (1 + NEAR)));
      default -> top(x, y, sets, system.operators());
    };
  }

  private double[] implied(Rule rule, Variable variable, int term, double[] x) {
    DoubleBinaryOperator implication = operator(system.operators().implication().name());
    double strength = strength(rule);
    return Arrays.stream(x)
        .map(each -> implication.applyAsDouble(strength, membership(variable, term, each)))
        .toArray();
  }

  private static double half(double[] x, double[] y, double area) {
    double left = 0;
    for (int i = 0; i <= LAST; i++) {
      left += y[i];
      if (2 * left >= area) {
        return x[i];
      }
    }
    return x[LAST];
  }

  private static Answer top(double[] x, double[] y, List<double[]> sets, Operators methods) {
    double top = Arrays.stream(y).max().orElseThrow();
    double nearly = top * (1 - NEAR);
    double[] exact = places(x, y, top);
    double[] near = places(x, y, nearly);
    boolean isCutFlat =
        methods.aggregation() == Operators.Aggregation.MAX
            && methods.implication() == Operators.Implication.MIN;
    // Where two rules are equally strong, rounding may lift one of them above the other.
    boolean isOneTop =
        sets.stream()
            .map(set -> places(x, set, nearly))
            .allMatch(places -> places.length == 0 || Arrays.equals(places, near));
    if (near.length > exact.length || !isCutFlat || !isOneTop) {
      return new Answer(near[0], near[near.length - 1]);
    }
    return Answer.of(
        switch (methods.defuzzification()) {
          case MOM -> Arrays.stream(exact).average().orElseThrow();
          case SOM -> Arrays.stream(exact).boxed().min(BruteForce::byAmount).orElseThrow();
          case LOM -> Arrays.stream(exact).boxed().max(BruteForce::byAmount).orElseThrow();
          default -> throw new IllegalArgumentException(methods.toString());
        });
  }

  private static double[] places(double[] x, double[] y, double least) {
    return IntStream.rangeClosed(0, LAST)
        .filter(i -> y[i] >= least)
        .mapToDouble(i -> x[i])
        .toArray();
  }

  private static int byAmount(Double one, Double other) {
    return Double.compare(Math.abs(one), Math.abs(other));
  }

  private static double membership(Variable variable, int term, double x) {
    Term named = variable.terms().get(Math.abs(term) - 1);
    double y = shape(named.function().fisName(), named.function().parameters()).applyAsDouble(x);
    return term > 0 ? y : 1 - y;
  }

  private static DoubleUnaryOperator shape(String word, List<Double> p) {
    return switch (word) {
      case "trimf" -> x -> trapezium(x, p.get(0), p.get(1), p.get(1), p.get(2));
      case "trapmf" -> x -> trapezium(x, p.get(0), p.get(1), p.get(2), p.get(3));
      case "gaussmf" -> x -> Math.exp(-0.5 * Math.pow((x - p.get(1)) / p.get(0), 2));
      case "gauss2mf" ->
          x ->
              (x < p.get(1) ? Math.exp(-0.5 * Math.pow((x - p.get(1)) / p.get(0), 2)) : 1)
                  * (x > p.get(3) ? Math.exp(-0.5 * Math.pow((x - p.get(3)) / p.get(2), 2)) : 1);
      case "gbellmf" -> x -> 1 / (1 + Math.pow(Math.abs((x - p.get(2)) / p.get(0)), 2 * p.get(1)));
      case "sigmf" -> x -> sigmoid(x, p.get(0), p.get(1));
      case "dsigmf" ->
          x -> Math.abs(sigmoid(x, p.get(0), p.get(1)) - sigmoid(x, p.get(2), p.get(3)));
      case "psigmf" -> x -> sigmoid(x, p.get(0), p.get(1)) * sigmoid(x, p.get(2), p.get(3));
      case "smf" -> x -> smooth(x, p.get(0), p.get(1));
      case "zmf" -> x -> smooth(-x, -p.get(1), -p.get(0));
      case "pimf" -> x -> smooth(x, p.get(0), p.get(1)) * smooth(-x, -p.get(3), -p.get(2));
      default -> throw new IllegalArgumentException(word);
    };
  }

  private static double trapezium(double x, double a, double b, double c, double d) {
    double up = x >= b ? 1 : a == b ? 0 : Math.max(0, (x - a) / (b - a));
    double down = x <= c ? 1 : c == d ? 0 : Math.max(0, (d - x) / (d - c));
    return Math.min(up, down);
  }

  private static double sigmoid(double x, double a, double c) {
    return 1 / (1 + Math.exp(a * (c - x)));
  }

  private static double smooth(double x, double a, double b) {
    if (a >= b) {
      return x >= (a + b) / 2 ? 1 : 0;
    }
    double t = Math.min(1, Math.max(0, (x - a) / (b - a)));
    return t < 0.5 ? 2 * t * t : 1 - 2 * (1 - t) * (1 - t);
  }
}
