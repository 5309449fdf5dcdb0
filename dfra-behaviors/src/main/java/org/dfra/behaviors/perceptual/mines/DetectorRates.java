package org.dfra.behaviors.perceptual.mines;

/**
 * Detection rates of a detector.
 *
 * @param truePositive probability of an alarm where there is a mine, above 0 and below 1
 * @param falsePositive probability of an alarm where there is none, above 0 and below 1
 * @param trust fraction of the observations for which these rates hold, 0 to 1; the rest is unknown
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

  /** Evidence of an alarm. */
  public Evidence alarm() {
    return new Evidence(truePositive, falsePositive, trust);
  }

  /** Evidence of an observation without an alarm. */
  public Evidence noAlarm() {
    return new Evidence(1 - truePositive, 1 - falsePositive, trust);
  }
}
