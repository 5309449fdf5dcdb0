package org.dfra.cli.stop;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.UUID;
import org.dfra.cli.stop.PhoenixAddresses.Address;
import org.dfra.cli.stop.PhoenixAddresses.Origin;
import org.dfra.river.phoenix.stop.EffectorStopResult;
import org.dfra.river.phoenix.stop.StopReport;
import org.dfra.river.phoenix.stop.UnconfirmedGroup;
import org.jspecify.annotations.Nullable;

/**
 * The report of one phoenix that received a stop request.
 *
 * @param address of the request
 * @param origin the source of the address
 * @param isUnresponsive whether a phoenix may run there, and none answered
 * @param stops result of each effector, by its ID: of several results the last one, unless an
 *     earlier one confirms the stop
 * @param robots names of the robots that have a group on it
 * @param unconfirmed groups that did not answer its last request
 */
record PhoenixAnswer(
    Address address,
    Origin origin,
    boolean isUnresponsive,
    Map<UUID, EffectorStopResult> stops,
    Set<String> robots,
    List<UnconfirmedGroup> unconfirmed) {

  /**
   * The answer of a phoenix.
   *
   * @param reports its reports, the last one last
   */
  static PhoenixAnswer of(Address address, Origin origin, List<StopReport> reports) {
    Map<UUID, EffectorStopResult> stops = new LinkedHashMap<>();
    Set<String> robots = new TreeSet<>();
    for (StopReport report : reports) {
      robots.addAll(report.robots());
      for (EffectorStopResult stop : report.effectors()) {
        stops.merge(
            stop.id(), stop, (old, now) -> old.isConfirmed() && !now.isConfirmed() ? old : now);
      }
    }
    List<UnconfirmedGroup> unconfirmed =
        reports.isEmpty() ? List.of() : reports.get(reports.size() - 1).unconfirmed();
    return new PhoenixAnswer(address, origin, false, stops, robots, unconfirmed);
  }

  /** No answer from an address where a phoenix may run. */
  static PhoenixAnswer unresponsive(Address address, Origin origin) {
    return new PhoenixAnswer(address, origin, true, Map.of(), Set.of(), List.of());
  }

  /** Nothing from a phoenix that was discovered and has not been asked. */
  static PhoenixAnswer notAsked(Address address) {
    return unresponsive(address, Origin.DISCOVERY);
  }

  /** Whether the operator named it, or its computer; otherwise a discovered lookup service did. */
  boolean isConfigured() {
    return origin.isConfigured();
  }

  /** Whether it confirms the stop of an effector, under any path. */
  boolean confirms(UUID id) {
    @Nullable EffectorStopResult stop = stops.get(id);
    return stop != null && stop.isConfirmed();
  }

  /** Whether it confirms the stop of an effector under that path. */
  boolean confirms(UUID id, String path) {
    @Nullable EffectorStopResult stop = stops.get(id);
    return stop != null && stop.isConfirmed() && stop.path().equals(path);
  }
}
