package org.dfra.drivers.gps.m12;

/**
 * {@code @@Hn} and {@code @@En}: whether the satellites agree on the time (time RAIM, receiver
 * autonomous integrity monitoring). Source: Motorola Oncore user's guides; the offsets of solution
 * status and sawtooth are those of the NTP project's drivers.
 *
 * @param id {@code Hn} of twelve channels, {@code En} of eight
 * @param pulse whether the receiver gives its pulse each second
 * @param solution result for the last solution
 * @param ability what can be detected with the satellites in view
 * @param removed satellites removed from the solution, one bit each, the lowest is satellite 1; 0
 *     where the message does not contain it
 * @param accuracy the time solution's accuracy, one sigma, nanoseconds
 * @param sawtooth how much too early the next pulse is, nanoseconds
 */
public record TimeRaim(
    String id,
    boolean pulse,
    Solution solution,
    Ability ability,
    long removed,
    int accuracy,
    int sawtooth)
    implements M12Message {

  /** Result for a solution. */
  public enum Solution {
    /** Within the alarm limit. */
    OK,
    /** Beyond the alarm limit: do not use it. */
    ALARM,
    /** Not known: too few satellites, or time RAIM is off. */
    UNKNOWN
  }

  /** What can be detected with the satellites in view. */
  public enum Ability {
    /** A faulty satellite can be detected and removed. */
    DETECTION_AND_ISOLATION,
    /** A faulty satellite can only be detected. */
    DETECTION,
    /** Neither. */
    NONE
  }

  /** {@code OK, detection and isolation, accuracy 54 ns}. */
  public String inWords() {
    return solution
        + ", "
        + switch (ability) {
          case DETECTION_AND_ISOLATION -> "a wrong satellite would be detected and taken out";
          case DETECTION -> "a wrong satellite would be detected";
          case NONE -> "a wrong satellite would not be detected";
        }
        + ", time accurate to "
        + accuracy
        + " ns";
  }
}
