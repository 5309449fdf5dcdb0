package org.dfra.river.phoenix.stop;

import java.io.Serializable;
import java.util.List;

/**
 * What has become of the effectors that phoenix was to stop.
 *
 * @param robots names of all robots that have a group on this phoenix, sorted, whichever were to be
 *     stopped
 * @param effectors what each effector answered
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
