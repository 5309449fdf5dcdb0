package org.dfra.behaviors.fuzzy;

import org.dfra.behaviors.fuzzy.Operators.Defuzzification;
import org.jspecify.annotations.Nullable;

/** Sugeno's inference: each rule gives a number, and these are averaged or summed. */
final class SugenoInference extends Inference {

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
