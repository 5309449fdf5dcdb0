package org.dfra.behaviors.perceptual.mines;

import org.dfra.behaviors.perceptual.mines.EvidenceCombination.Evidence;

/**
 * Detection rates of a camera in repeated observations of one position. Errors repeat: a false
 * alarm tends to recur, and so does a miss; so the evidence of an observation depends on the
 * previous result.
 *
 * @param first of its first observation of a position
 * @param afterAlarm of an observation after an alarm
 * @param afterSilence of an observation after none
 */
public record RepeatedDetectionRates(
    RepeatedDetectionRates.DetectorRates first,
    RepeatedDetectionRates.DetectorRates afterAlarm,
    RepeatedDetectionRates.DetectorRates afterSilence) {

  /** The previous result. */
  public enum PreviousResult {
    /** No previous observation. */
    NONE,
    /** An alarm. */
    ALARM,
    /** No alarm. */
    NO_ALARM;

    /** The result of an observation, for the next one. */
    public static PreviousResult of(boolean isAlarm) {
      return isAlarm ? ALARM : NO_ALARM;
    }
  }

  /** The evidence of an observation. */
  public Evidence evidence(PreviousResult before, boolean isAlarm) {
    DetectorRates rates =
        switch (before) {
          case NONE -> first;
          case ALARM -> afterAlarm;
          case NO_ALARM -> afterSilence;
        };
    return isAlarm ? rates.alarm() : rates.noAlarm();
  }

  /**
   * Detection rates of a detector.
   *
   * @param truePositive probability of an alarm where there is a mine, above 0 and below 1
   * @param falsePositive probability of an alarm where there is none, above 0 and below 1
   * @param trust fraction of the observations for which these rates hold, 0 to 1; the rest is
   *     unknown
   */
  public record DetectorRates(double truePositive, double falsePositive, double trust) {

    public DetectorRates {
      if (!(truePositive > 0 && truePositive < 1 && falsePositive > 0 && falsePositive < 1)) {
        throw new IllegalArgumentException(
            "rates of "
                + truePositive
                + " and "
                + falsePositive
                + " are not both above 0 and below 1");
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
}
