package org.dfra.behaviors.fuzzy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.Random;
import org.dfra.behaviors.fuzzy.FuzzySystem.Rule;
import org.dfra.behaviors.fuzzy.FuzzySystem.ToolboxCompatibility;
import org.dfra.behaviors.fuzzy.Operators.Defuzzification;
import org.dfra.behaviors.fuzzy.Variable.Term;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class InferenceTest {

  private static final int SYSTEMS = Boolean.getBoolean("dfra.full") ? 20_000 : 2_000;

  /** The restaurant of MATLAB's documentation, and the tips it says. */
  private static FuzzySystem tipper(Defuzzification defuzzification) {
    Variable service =
        new Variable(
            "service",
            0,
            10,
            List.of(
                set("poor", MembershipFunctionType.GAUSSMF, 1.5, 0.0),
                set("good", MembershipFunctionType.GAUSSMF, 1.5, 5.0),
                set("excellent", MembershipFunctionType.GAUSSMF, 1.5, 10.0)));
    Variable food =
        new Variable(
            "food",
            0,
            10,
            List.of(
                set("rancid", MembershipFunctionType.TRAPMF, -2.0, 0.0, 1.0, 3.0),
                set("delicious", MembershipFunctionType.TRAPMF, 7.0, 9.0, 10.0, 12.0)));
    Variable tip =
        new Variable(
            "tip",
            0,
            30,
            List.of(
                set("cheap", MembershipFunctionType.TRIMF, 0.0, 5.0, 10.0),
                set("average", MembershipFunctionType.TRIMF, 10.0, 15.0, 20.0),
                set("generous", MembershipFunctionType.TRIMF, 20.0, 25.0, 30.0)));
    Operators usual = Operators.MAMDANI;
    return new FuzzySystem(
        "tipper",
        FuzzySystem.Type.MAMDANI,
        new Operators(
            usual.and(), usual.or(), usual.implication(), usual.aggregation(), defuzzification),
        List.of(service, food),
        List.of(tip),
        List.of(
            new Rule(List.of(1, 1), List.of(1), 1, Rule.Connective.OR),
            new Rule(List.of(2, 0), List.of(2), 1, Rule.Connective.AND),
            new Rule(List.of(3, 2), List.of(3), 1, Rule.Connective.OR)));
  }

  private static Term set(String name, MembershipFunctionType type, Double... parameters) {
    return new Term(name, new MembershipFunction(type, List.of(parameters)));
  }

  private static double tip(FuzzySystem system, double service, double food) {
    double[] tip = new double[1];
    system.inference().evaluate(new double[] {service, food}, tip);
    return tip[0];
  }

  @ParameterizedTest
  @CsvSource({"2, 1, 7.0169", "4, 5, 14.4585", "7, 8, 20.3414"})
  void tipsAsTheDocumentationSays(double service, double food, double tip) {
    assertThat(tip(tipper(Defuzzification.CENTROID), service, food)).isCloseTo(tip, within(5e-5));
  }

  @Test
  void defuzzifiesByEachMethodWhereASetIsCutFlat() {
    // Poor service and rancid food: "cheap" is cut at 1, so its top is the one point x = 5.1.
    assertThat(tip(tipper(Defuzzification.MOM), 0, 0)).isCloseTo(5.1, within(0.2));
    double smallest = tip(tipper(Defuzzification.SOM), 2, 2);
    double mean = tip(tipper(Defuzzification.MOM), 2, 2);
    double largest = tip(tipper(Defuzzification.LOM), 2, 2);
    assertThat(smallest).isLessThan(mean);
    assertThat(mean).isLessThan(largest).isCloseTo((smallest + largest) / 2, within(1e-9));
  }

  @Test
  void agreesWithTheDefinitionOnRandomSystems() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    RandomSystems systems = new RandomSystems(seed);
    for (int i = 0; i < SYSTEMS; i++) {
      FuzzySystem system = systems.next();
      Inference inference = system.inference();
      double[] outputs = new double[system.outputs().size()];
      for (int j = 0; j < 3; j++) {
        double[] inputs = systems.inputs(system);
        inference.evaluate(inputs, outputs);
        List<BruteForce.Answer> answers = BruteForce.matlab(system, inputs);
        for (int output = 0; output < outputs.length; output++) {
          assertThat(outputs[output])
              .as("-Ddfra.seed=%d, system %d, %s: %s", seed, i, answers.get(output), system)
              .matches(answers.get(output)::admits);
        }
      }
    }
  }

  @Test
  void withoutAFiringRuleMatlabGivesTheMiddleAndOctaveNothing() {
    FuzzySystem silent =
        new FuzzySystem(
            "silent",
            FuzzySystem.Type.MAMDANI,
            Operators.MAMDANI,
            List.of(
                new Variable(
                    "x", 0, 10, List.of(set("low", MembershipFunctionType.TRIMF, 0.0, 1.0, 2.0)))),
            List.of(
                new Variable(
                    "y", -2, 8, List.of(set("some", MembershipFunctionType.TRIMF, 0.0, 1.0, 2.0)))),
            List.of(new Rule(List.of(1), List.of(1), 1, Rule.Connective.AND)));
    double[] y = new double[1];
    silent.inference(ToolboxCompatibility.MATLAB).evaluate(new double[] {5}, y);
    assertThat(y[0]).isEqualTo(3);
    silent.inference(ToolboxCompatibility.OCTAVE).evaluate(new double[] {5}, y);
    assertThat(y[0]).isNaN();
  }

  @Test
  void allocatesNothing() {
    var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    long self = Thread.currentThread().getId();
    Inference inference = tipper(Defuzzification.CENTROID).inference();
    double[] inputs = {2, 1};
    double[] outputs = new double[1];
    inference.evaluate(inputs, outputs); // loads what is loaded once
    long before = threads.getThreadAllocatedBytes(self);
    long after = threads.getThreadAllocatedBytes(self);
    long asking = after - before;
    before = threads.getThreadAllocatedBytes(self);
    for (int i = 0; i < 1_000; i++) {
      inference.evaluate(inputs, outputs);
    }
    after = threads.getThreadAllocatedBytes(self);
    assertThat(after - before).as("bytes in 1000 evaluations").isLessThanOrEqualTo(asking);
  }

  @Test
  void refusesWhatDoesNotFitTheSystem() {
    Inference inference = tipper(Defuzzification.CENTROID).inference();
    assertThatThrownBy(() -> inference.evaluate(new double[3], new double[1]))
        .hasMessage("tipper has 2 inputs and 1 outputs, not 3 and 1");
    assertThatThrownBy(() -> inference.evaluate(new double[] {1, Double.NaN}, new double[1]))
        .hasMessage("input food of tipper is not a number");
  }

  @Test
  void refusesASystemThatDoesNotFitTogether() {
    FuzzySystem good = tipper(Defuzzification.CENTROID);
    assertThatThrownBy(
            () ->
                new FuzzySystem(
                    "t",
                    good.type(),
                    good.operators(),
                    good.inputs(),
                    good.outputs(),
                    List.of(new Rule(List.of(1, 3), List.of(1), 1, Rule.Connective.AND))))
        .hasMessage("rule 1 uses term 3 of food, which has 2 terms");
    assertThatThrownBy(
            () ->
                new FuzzySystem(
                    "t", good.type(), Operators.SUGENO, good.inputs(), good.outputs(), List.of()))
        .hasMessage("the defuzzification wtaver is not for a system of type mamdani");
    assertThatThrownBy(
            () -> new MembershipFunction(MembershipFunctionType.TRIMF, List.of(1.0, 0.0, 2.0)))
        .hasMessage("trimf [a, b, c] requires a ≤ b ≤ c, not [1.0, 0.0, 2.0]");
    assertThatThrownBy(() -> new Rule(List.of(1), List.of(1), 1.5, Rule.Connective.AND))
        .hasMessage("the weight 1.5 is not from 0 to 1");
  }
}
