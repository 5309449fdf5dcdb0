package org.dfra.river.phoenix.stop;

import java.io.Serializable;
import java.util.List;

/**
 * The results of an emergency stop by phoenix.
 *
 * @param robots names of all robots that have a group on this phoenix, sorted, also those that were
 *     not to be stopped
 * @param effectors the answer of each effector
 * @param unconfirmed groups of which not every effector answered
 */
public record StopReport(
    List<String> robots, List<EffectorStopResult> effectors, List<UnconfirmedGroup> unconfirmed)
    implements Serializable {

  public StopReport {
    robots = List.copyOf(robots);
    effectors = List.copyOf(effectors);
    unconfirmed = List.copyOf(unconfirmed);
  }
}
