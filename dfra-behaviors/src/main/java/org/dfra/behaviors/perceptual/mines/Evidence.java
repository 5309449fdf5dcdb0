package org.dfra.behaviors.perceptual.mines;

/**
 * What one look at a place tells. Only the ratio of the likelihoods counts. Looks are taken to be
 * independent: two from one place in one light are not, and should be given as one.
 *
 * @param ifMine likelihood of what was seen where there is a mine, above 0
 * @param ifClear likelihood of what was seen where there is none, above 0
 * @param trust part of such looks for which the likelihoods hold, 0 to 1
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
