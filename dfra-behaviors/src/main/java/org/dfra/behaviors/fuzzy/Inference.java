package org.dfra.behaviors.fuzzy;

/**
 * Evaluates one fuzzy system. It allocates no memory after construction; use one instance per
 * thread.
 */
public abstract sealed class Inference permits MamdaniInference, SugenoInference {

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
}
