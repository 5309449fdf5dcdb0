package org.dfra.behaviors.fuzzy;

import java.util.Arrays;
import org.dfra.behaviors.fuzzy.FuzzySystem.ToolboxCompatibility;
import org.dfra.behaviors.fuzzy.Operators.Defuzzification;
import org.jspecify.annotations.Nullable;

/**
 * Evaluates one fuzzy system. It allocates no memory after construction; use one instance per
 * thread.
 */
public abstract sealed class Inference
    permits Inference.MamdaniInference, Inference.SugenoInference {

  private final FuzzySystem system;
  private final RuleBase rules;

  Inference(FuzzySystem system) {
    this.system = system;
    this.rules = new RuleBase(system);
  }

  /** The evaluated system. */
  public FuzzySystem system() {
    return system;
  }

  /**
   * Evaluates the system. Inputs beyond their ranges are not clamped.
   *
   * @param inputs a value for each input, in its own unit
   * @param outputs receives a value for each output, in its own unit
   * @throws IllegalArgumentException if the arrays do not fit the system, or an input is not a
   *     number
   */
  public void evaluate(double[] inputs, double[] outputs) {
    if (inputs.length != system.inputs().size() || outputs.length != system.outputs().size()) {
      throw new IllegalArgumentException(
          system.name()
              + " has "
              + system.inputs().size()
              + " inputs and "
              + system.outputs().size()
              + " outputs, not "
              + inputs.length
              + " and "
              + outputs.length);
    }
    for (int i = 0; i < inputs.length; i++) {
      if (Double.isNaN(inputs[i])) {
        throw new IllegalArgumentException(
            "input " + system.inputs().get(i).name() + " of " + system.name() + " is not a number");
      }
    }
    defuzzify(inputs, rules.fire(inputs), outputs);
  }

  /** The firing strengths of the last evaluation, one for each rule; do not modify. */
  public double[] strengths() {
    return rules.strengths();
  }

  abstract void defuzzify(double[] inputs, double[] strengths, double[] outputs);

  /** Mamdani's inference: each rule gives a fuzzy set; these are aggregated and defuzzified. */
  static final class MamdaniInference extends Inference {

    private final OutputAggregator[] outputs;
    private final Defuzzifier defuzzifier;

    MamdaniInference(FuzzySystem system, ToolboxCompatibility engine) {
      super(system);
      outputs = new OutputAggregator[system.outputs().size()];
      Arrays.setAll(outputs, output -> new OutputAggregator(system, output));
      defuzzifier = new Defuzzifier(system.operators().defuzzification(), engine);
    }

    @Override
    void defuzzify(double[] inputs, double[] strengths, double[] results) {
      for (int output = 0; output < outputs.length; output++) {
        OutputAggregator sets = outputs[output];
        results[output] =
            defuzzifier.defuzzify(sets.grid(), sets.aggregate(strengths), sets.middle());
      }
    }
  }

  /** Sugeno's inference: each rule gives a number, and these are averaged or summed. */
  static final class SugenoInference extends Inference {

    private final @Nullable LinearFunction[][] consequents; // by output and rule; null for none
    private final double[] defaultOutputs; // output where no rule fires
    private final boolean isMean;

    SugenoInference(FuzzySystem system, ToolboxCompatibility engine) {
      super(system);
      int rules = system.rules().size();
      int outputs = system.outputs().size();
      isMean = system.operators().defuzzification() == Defuzzification.WTAVER;
      consequents = new @Nullable LinearFunction[outputs][rules];
      defaultOutputs = new double[outputs];
      for (int output = 0; output < outputs; output++) {
        Variable variable = system.outputs().get(output);
        defaultOutputs[output] =
            engine == ToolboxCompatibility.MATLAB ? variable.middle() : Double.NaN;
        for (int rule = 0; rule < rules; rule++) {
          int term = system.rules().get(rule).consequents().get(output);
          consequents[output][rule] =
              term == 0 ? null : (LinearFunction) variable.terms().get(term - 1).function();
        }
      }
    }

    @Override
    void defuzzify(double[] inputs, double[] strengths, double[] outputs) {
      for (int output = 0; output < outputs.length; output++) {
        double sum = 0;
        double total = 0;
        for (int rule = 0; rule < strengths.length; rule++) {
          @Nullable LinearFunction consequent = consequents[output][rule];
          if (consequent != null) {
            sum += strengths[rule] * consequent.at(inputs);
            total += strengths[rule];
          }
        }
        if (isMean) {
          outputs[output] = total == 0 ? defaultOutputs[output] : sum / total;
        } else {
          outputs[output] = sum;
        }
      }
    }
  }
}
