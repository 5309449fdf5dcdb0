package org.dfra.behaviors.perceptual.mines;

/**
 * How often a camera's alarms are right when it looks at one place again and again. What it took
 * for a mine once it takes for one again, and what it overlooked it overlooks again; so a look
 * counts by what the look before it said.
 *
 * @param first of its first look at a place
 * @param afterAlarm of a look after one that raised an alarm
 * @param afterSilence of a look after one that raised none
 */
public record RepeatedDetectionRates(
    DetectorRates first, DetectorRates afterAlarm, DetectorRates afterSilence) {

  /** What the look before said. */
  public enum PreviousResult {
    /** There was none. */
    NONE,
    /** An alarm. */
    ALARM,
    /** That there is nothing. */
    NO_ALARM;

    /** What a look says to the one that comes after it. */
    public static PreviousResult of(boolean isAlarm) {
      return isAlarm ? ALARM : NO_ALARM;
    }
  }

  /** What a look tells. */
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
