package org.dfra.benchmarks.scale;

import java.util.List;

/**
 * What a team of one size costs.
 *
 * @param robots number of robots
 * @param observed with one observer
 * @param mutual with each robot observing all
 */
public record TeamResult(int robots, Observed observed, Mutual mutual) {

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

  /**
   * One observer knows the team.
   *
   * @param complete seconds until it knew all modules
   * @param observer its traffic in a second, and its threads
   * @param robots the sum of the robots' traffic in a second
   * @param changes seconds from each of some changes until the observer saw it
   */
  public record Observed(double complete, Load observer, Load robots, List<Double> changes) {

    public Observed {
      changes = List.copyOf(changes);
    }
  }

  /**
   * Each robot knows the team.
   *
   * @param complete seconds until a process's robots knew all modules, the longest
   * @param robot the mean of the robots' traffic in a second; its threads are those of the
   *     processes divided by the number of robots
   * @param cpu CPU time of all processes in a second, seconds
   */
  public record Mutual(double complete, Load robot, double cpu) {}
}
