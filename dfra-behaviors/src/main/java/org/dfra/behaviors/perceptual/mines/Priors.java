package org.dfra.behaviors.perceptual.mines;

/** What a probability before all looks must be. */
final class Priors {

  private Priors() {}

  static double checked(double prior) {
    if (!(prior > 0 && prior < 1)) {
      throw new IllegalArgumentException(
          "prior " + prior + " is not above 0 and below 1; evidence could not change it");
    }
    return prior;
  }
}
