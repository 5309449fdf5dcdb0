package org.dfra.app.stop;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.UUID;
import org.dfra.river.phoenix.stop.EffectorStop;
import org.dfra.river.phoenix.stop.StopReport;
import org.dfra.river.phoenix.stop.UnconfirmedGroup;

/**
 * What the phoenixes that were asked say, put together.
 *
 * @param stops what each effector answered to its phoenix, by its identity: of several answers of
 *     one phoenix one that confirms the stop; of several phoenixes, of which all but one are false,
 *     one that does not
 * @param robots names of the robots that have a group on a phoenix that answered
 * @param unconfirmed groups that did not answer their phoenix at last
 * @param silent where a phoenix may run that did not answer, as {@code host:port}
 */
record Confirmations(
    Map<UUID, EffectorStop> stops,
    Set<String> robots,
    List<UnconfirmedGroup> unconfirmed,
    List<String> silent) {

  /**
   * Those of several phoenixes.
   *
   * @param reports for each phoenix what it reported, the last report last
   * @param silent where none answered
   */
  static Confirmations of(Collection<List<StopReport>> reports, List<String> silent) {
    Map<UUID, EffectorStop> stops = new LinkedHashMap<>();
    Set<String> robots = new TreeSet<>();
    List<UnconfirmedGroup> unconfirmed = new ArrayList<>();
    for (List<StopReport> ofOne : reports) {
      Map<UUID, EffectorStop> its = new LinkedHashMap<>();
      for (StopReport report : ofOne) {
        robots.addAll(report.robots());
        for (EffectorStop stop : report.effectors()) {
          its.merge(
              stop.id(), stop, (old, now) -> old.isConfirmed() && !now.isConfirmed() ? old : now);
        }
      }
      its.forEach(
          (id, stop) -> stops.merge(id, stop, (one, other) -> one.isConfirmed() ? other : one));
      if (!ofOne.isEmpty()) {
        unconfirmed.addAll(ofOne.get(ofOne.size() - 1).unconfirmed());
      }
    }
    return new Confirmations(stops, robots, unconfirmed, silent);
  }

  /**
   * Why the word of an effector's proxy does not count as its stop; empty where it counts, since no
   * phoenix knows its robot and none that might is silent.
   *
   * @param robot name of the robot that the proxy is registered for
   */
  Optional<String> doubtOf(String robot) {
    if (robots.contains(robot)) {
      return Optional.of(
          "its proxy says that it is stopped, and the phoenix of its robot does not confirm that");
    } else if (!silent.isEmpty()) {
      return Optional.of(
          "its proxy says that it is stopped, and no phoenix confirms that: none answers at "
              + String.join(", ", silent));
    }
    return Optional.empty();
  }

  /** Whether every effector and group that a phoenix knows has confirmed its stop. */
  boolean isComplete() {
    return unconfirmed.isEmpty() && stops.values().stream().allMatch(EffectorStop::isConfirmed);
  }
}
