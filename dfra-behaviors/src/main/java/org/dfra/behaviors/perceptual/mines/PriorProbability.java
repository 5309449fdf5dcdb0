package org.dfra.behaviors.perceptual.mines;

/** Validation of a prior probability. */
final class PriorProbability {

  private PriorProbability() {}

  static double requireValid(double prior) {
    if (!(prior > 0 && prior < 1)) {
      throw new IllegalArgumentException(
          "prior " + prior + " is not above 0 and below 1; evidence could not change it");
    }
    return prior;
  }
}
