package org.dfra.recruit.experiment;

/**
 * What came of one run.
 *
 * @param seed it was made with
 * @param calls how many calls for help there were
 * @param completed in how many of them a helper came and all knew
 * @param successes in how many of those it came within the deadline
 * @param transmissions how often something was sent, a broadcast counted once
 * @param receptions the same, a broadcast counted once for each that it was meant for
 * @param allocation mean time from a call to the first choice, seconds; NaN where nobody was chosen
 * @param arrival mean time from a call to the helper's arrival, seconds; NaN where nobody came
 * @param regret mean of how much longer the chosen robot needed than the nearest free one, seconds;
 *     NaN where nobody was chosen
 * @param duplicateHelpers how often a second robot was on its way to a call or there
 * @param orphanedHelpers how often a robot was on its way or there for longer than 2 s though its
 *     requester did not count on it; robots that were not free in the end are among them
 * @param rasterTimeLost by scanners that were called away, seconds
 * @param travel of each ground vehicle for others and back, metres, mean
 */
public record RunResult(
    long seed,
    int calls,
    int completed,
    int successes,
    long transmissions,
    long receptions,
    double allocation,
    double arrival,
    double regret,
    int duplicateHelpers,
    int orphanedHelpers,
    double rasterTimeLost,
    double travel) {

  /** Transmissions for each recruitment that was completed; NaN where none was. */
  public double transmissionsEach() {
    return completed == 0 ? Double.NaN : (double) transmissions / completed;
  }

  /** Likewise with a broadcast counted for each robot. */
  public double receptionsEach() {
    return completed == 0 ? Double.NaN : (double) receptions / completed;
  }
}
