package org.dfra.behaviors.perceptual.mines;

/**
 * Evidence from one observation of a position. Only the ratio of the likelihoods matters.
 * Observations are assumed independent: two from the same viewpoint and lighting are not; pass them
 * as one.
 *
 * @param ifMine likelihood of the observation where there is a mine, above 0
 * @param ifClear likelihood of the observation where there is none, above 0
 * @param trust fraction of such observations for which the likelihoods hold, 0 to 1
 */
public record Evidence(double ifMine, double ifClear, double trust) {

  public Evidence {
    double sum = ifMine + ifClear;
    if (!(ifMine > 0 && ifClear > 0 && sum < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(
          "likelihoods of " + ifMine + " and " + ifClear + " are not both finite and above 0");
    }
    if (!(trust >= 0 && trust <= 1)) {
      throw new IllegalArgumentException("trust " + trust + " is outside 0 to 1");
    }
  }
}
