package org.dfra.behaviors.perceptual.mines;

/**
 * How often a detector is right.
 *
 * @param truePositive probability of an alarm where there is a mine, above 0 and below 1
 * @param falsePositive probability of an alarm where there is none, above 0 and below 1
 * @param trust part of the looks for which these rates hold, 0 to 1; of the rest nothing is known
 */
public record DetectorRates(double truePositive, double falsePositive, double trust) {

  public DetectorRates {
    if (!(truePositive > 0 && truePositive < 1 && falsePositive > 0 && falsePositive < 1)) {
      throw new IllegalArgumentException(
          "rates of "
              + truePositive
              + " and "
              + falsePositive
              + " are not both above 0 and below 1; no detector is certain");
    }
    if (!(trust >= 0 && trust <= 1)) {
      throw new IllegalArgumentException("trust " + trust + " is outside 0 to 1");
    }
  }

  /** What it means that the detector raises an alarm. */
  public Evidence alarm() {
    return new Evidence(truePositive, falsePositive, trust);
  }

  /** What it means that it looked and raised none. */
  public Evidence noAlarm() {
    return new Evidence(1 - truePositive, 1 - falsePositive, trust);
  }
}
