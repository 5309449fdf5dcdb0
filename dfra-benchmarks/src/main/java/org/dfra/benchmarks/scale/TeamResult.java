package org.dfra.benchmarks.scale;

import java.util.List;

/**
 * What a team of one size costs.
 *
 * @param robots number of robots
 * @param complete seconds until one observer knew all modules
 * @param observer the observer's traffic in a second, and its threads
 * @param observed the sum of the robots' traffic in a second, while one observer knows them
 * @param changes seconds from each of some changes until the observer saw it
 * @param allComplete seconds until the last robot knew all modules of all robots
 * @param robot the mean of the robots' traffic in a second, while each knows all; threads likewise,
 *     of the processes divided by the number of robots
 * @param cpu CPU time of all processes in a second then, seconds
 */
public record TeamResult(
    int robots,
    double complete,
    Load observer,
    Load observed,
    List<Double> changes,
    double allComplete,
    Load robot,
    double cpu) {

  public TeamResult {
    changes = List.copyOf(changes);
  }

  /**
   * What a process does in a second.
   *
   * @param calls number of calls that it makes
   * @param bytes in both directions
   * @param threads number of its Java threads
   */
  public record Load(double calls, double bytes, double threads) {

    static Load of(ProcessTraffic perSecond, double share) {
      return new Load(
          perSecond.callsSent() / share, perSecond.bytes() / share, perSecond.threads() / share);
    }
  }
}
