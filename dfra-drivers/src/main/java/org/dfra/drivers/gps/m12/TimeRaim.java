package org.dfra.drivers.gps.m12;

/**
 * {@code @@Hn} and {@code @@En}: whether the satellites agree on the time (time RAIM, receiver
 * autonomous integrity monitoring). Source: Motorola Oncore user's guides; the places of solution
 * status and sawtooth as in the drivers of the NTP project.
 *
 * @param id {@code Hn} of twelve channels, {@code En} of eight
 * @param pulse whether the receiver gives its pulse each second
 * @param solution what the last solution was found to be
 * @param ability what the satellites in sight allow to be found
 * @param removed numbers of the satellites taken out of the solution, one bit each, the lowest is
 *     satellite 1; 0 where the message does not tell
 * @param accuracy the time solution's accuracy, one sigma, nanoseconds
 * @param sawtooth by how much the next pulse comes too early, nanoseconds
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

  /** What a solution was found to be. */
  public enum Solution {
    /** Within the alarm limit. */
    OK,
    /** Beyond the alarm limit: do not believe it. */
    ALARM,
    /** Not known: too few satellites, or time RAIM is off. */
    UNKNOWN
  }

  /** What can be found with the satellites in sight. */
  public enum Ability {
    /** A wrong satellite can be detected and taken out. */
    DETECTION_AND_ISOLATION,
    /** A wrong satellite can be detected only. */
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
