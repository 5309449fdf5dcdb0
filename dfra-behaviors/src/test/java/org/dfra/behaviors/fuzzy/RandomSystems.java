package org.dfra.behaviors.fuzzy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.dfra.behaviors.fuzzy.FuzzySystem.Rule;
import org.dfra.behaviors.fuzzy.Operators.Defuzzification;
import org.dfra.behaviors.fuzzy.Variable.Term;
import org.dfra.behaviors.fuzzy.Variable.TermFunction;

/** Fuzzy systems of every kind, drawn by a seed. */
final class RandomSystems {

  private final Random random;

  RandomSystems(long seed) {
    this.random = new Random(seed);
  }

  FuzzySystem next() {
    boolean isSugeno = random.nextInt(4) == 0;
    FuzzySystem.Type type = isSugeno ? FuzzySystem.Type.SUGENO : FuzzySystem.Type.MAMDANI;
    int inputs = 1 + random.nextInt(4);
    List<Variable> ins =
        IntStream.range(0, inputs).mapToObj(i -> variable("in" + i, inputs, false)).toList();
    List<Variable> outs =
        IntStream.range(0, 1 + random.nextInt(2))
            .mapToObj(i -> variable("out" + i, inputs, isSugeno))
            .toList();
    List<Defuzzification> fitting =
        Arrays.stream(Defuzzification.values())
            .filter(each -> each.isSugenoOnly() == isSugeno)
            .toList();
    Operators methods =
        new Operators(
            one(Operators.And.values()),
            one(Operators.Or.values()),
            one(Operators.Implication.values()),
            one(Operators.Aggregation.values()),
            fitting.get(random.nextInt(fitting.size())));
    List<Rule> rules = new ArrayList<>();
    for (int i = random.nextInt(12); i >= 0; i--) {
      rules.add(
          new Rule(
              ins.stream().map(each -> term(each, true)).toList(),
              outs.stream().map(each -> term(each, !isSugeno)).toList(),
              random.nextBoolean() ? 1 : random.nextDouble(),
              one(Rule.Connective.values())));
    }
    return new FuzzySystem("random", type, methods, ins, outs, rules);
  }

  /** Inputs, some of them beyond their ranges. */
  double[] inputs(FuzzySystem system) {
    return system.inputs().stream()
        .mapToDouble(
            each -> each.low() + (random.nextDouble() * 1.4 - 0.2) * (each.high() - each.low()))
        .toArray();
  }

  private <T> T one(T[] values) {
    return values[random.nextInt(values.length)];
  }

  private int term(Variable variable, boolean mayBeOpposite) {
    int term = random.nextInt(variable.terms().size() + 1);
    return mayBeOpposite && random.nextInt(4) == 0 ? -term : term;
  }

  private Variable variable(String name, int inputs, boolean hasFunctions) {
    double low = random.nextInt(20) - 10;
    double high = low + 1 + random.nextInt(20);
    List<Term> terms =
        IntStream.range(0, 1 + random.nextInt(5))
            .mapToObj(
                i -> new Term("t" + i, hasFunctions ? function(inputs) : membership(low, high)))
            .toList();
    return new Variable(name, low, high, terms);
  }

  private TermFunction function(int inputs) {
    return random.nextBoolean()
        ? LinearFunction.constant(random.nextGaussian())
        : LinearFunction.linear(
            IntStream.rangeClosed(0, inputs).mapToObj(i -> random.nextGaussian()).toList());
  }

  private MembershipFunction membership(double low, double high) {
    MembershipFunctionType type = one(MembershipFunctionType.values());
    double[] places =
        IntStream.range(0, 4)
            .mapToDouble(i -> low + (random.nextDouble() * 1.4 - 0.2) * (high - low))
            .map(x -> random.nextInt(4) == 0 ? Math.rint(x) : x)
            .sorted()
            .toArray();
    double width = (high - low) * (0.05 + random.nextDouble() / 3);
    double steep = (random.nextBoolean() ? 1 : -1) * (0.5 + 3 * random.nextDouble()) / width;
    List<Double> parameters =
        switch (type) {
          case TRIMF -> List.of(places[0], places[1], places[2]);
          case TRAPMF, PIMF -> List.of(places[0], places[1], places[2], places[3]);
          case GAUSSMF -> List.of(width, places[1]);
          case GAUSS2MF -> List.of(width, places[1], width / 2, places[2]);
          case GBELLMF -> List.of(width, 0.5 + 3 * random.nextDouble(), places[1]);
          case SIGMF -> List.of(steep, places[1]);
          case DSIGMF -> List.of(Math.abs(steep), places[0], Math.abs(steep), places[2]);
          case PSIGMF -> List.of(steep, places[0], -steep, places[2]);
          case SMF, ZMF ->
              random.nextInt(5) == 0
                  ? List.of(places[2], places[0])
                  : List.of(places[0], places[2]);
        };
    return new MembershipFunction(type, parameters);
  }
}
