package org.dfra.recruit.experiment;

/**
 * The result of one run.
 *
 * @param seed of the run
 * @param calls number of calls for help
 * @param completed number of those with a complete recruitment
 * @param successes number of those in which the helper arrived within the deadline
 * @param transmissions number of transmissions, a broadcast counted once
 * @param receptions the same, a broadcast counted once per receiver
 * @param allocation mean time from a call to the first choice, seconds; NaN where no robot was
 *     chosen
 * @param arrival mean time from a call to the helper's arrival, seconds; NaN where none arrived
 * @param regret mean excess travel time of the chosen robot over the nearest free one, seconds; NaN
 *     where none was chosen
 * @param duplicateHelpers number of times that a second robot was on its way to a call or there
 * @param orphanedHelpers number of times that a robot was on its way or there for longer than 2 s
 *     although its requester did not expect it; includes robots that were not free at the end
 * @param rasterTimeLost time of scanners away from their routes, seconds
 * @param travel mean distance of each ground vehicle for others and back, metres
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

  /** Transmissions per completed recruitment; NaN where none was. */
  public double transmissionsEach() {
    return completed == 0 ? Double.NaN : (double) transmissions / completed;
  }

  /** The same with a broadcast counted once per receiver. */
  public double receptionsEach() {
    return completed == 0 ? Double.NaN : (double) receptions / completed;
  }
}
