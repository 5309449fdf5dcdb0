package org.dfra.behaviors.fuzzy;

import java.util.Arrays;

/** Mamdani's inference: each rule gives a fuzzy set; these are put together and made a number. */
final class MamdaniInference extends Inference {

  private final OutputSets[] outputs;
  private final Defuzzifier defuzzifier;

  MamdaniInference(FuzzySystem system, Engine engine) {
    super(system);
    outputs = new OutputSets[system.outputs().size()];
    Arrays.setAll(outputs, output -> new OutputSets(system, output));
    defuzzifier = new Defuzzifier(system.methods().defuzzification(), engine);
  }

  @Override
  void defuzzify(double[] inputs, double[] strengths, double[] results) {
    for (int output = 0; output < outputs.length; output++) {
      OutputSets sets = outputs[output];
      results[output] = defuzzifier.number(sets.grid(), sets.aggregate(strengths), sets.middle());
    }
  }
}
