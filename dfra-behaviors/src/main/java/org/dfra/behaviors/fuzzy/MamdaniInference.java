package org.dfra.behaviors.fuzzy;

import java.util.Arrays;

/** Mamdani's inference: each rule gives a fuzzy set; these are aggregated and defuzzified. */
final class MamdaniInference extends Inference {

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
