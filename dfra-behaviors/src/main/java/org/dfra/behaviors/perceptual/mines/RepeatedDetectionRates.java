package org.dfra.behaviors.perceptual.mines;

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
    DetectorRates first, DetectorRates afterAlarm, DetectorRates afterSilence) {

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
}
