package org.dfra.cli.stop;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.UUID;
import java.util.stream.Collectors;
import org.dfra.river.phoenix.stop.EffectorStopResult;
import org.dfra.river.phoenix.stop.UnconfirmedGroup;

/**
 * The combined reports of the phoenixes that received the stop request. The report of a configured
 * phoenix is trusted. A discovered lookup service may be foreign, and may claim any computer as its
 * own: the report of a phoenix there counts no more than that of a proxy ({@link
 * #unconfirmedReason(EffectorStopResult, List)}).
 */
final class Confirmations {

  /** An effector in the report of a discovered phoenix: one ID may occur twice. */
  private record EffectorKey(UUID id, String path) {}

  private final List<PhoenixAnswer> answers;
  private final Map<UUID, EffectorStopResult> stops = new LinkedHashMap<>();
  private final Map<EffectorKey, EffectorStopResult> discovered = new LinkedHashMap<>();
  private final Set<String> robots = new TreeSet<>();
  private final List<UnconfirmedGroup> unconfirmed = new ArrayList<>();

  /**
   * @param answers of each phoenix
   */
  Confirmations(Collection<PhoenixAnswer> answers) {
    this.answers = List.copyOf(answers);
    for (PhoenixAnswer each : answers) {
      robots.addAll(each.robots());
      unconfirmed.addAll(each.unconfirmed());
      if (each.isConfigured()) {
        each.stops().forEach((id, stop) -> stops.merge(id, stop, Confirmations::worse));
      }
    }
    for (PhoenixAnswer each : answers) {
      if (!each.isConfigured()) {
        for (EffectorStopResult stop : each.stops().values()) {
          if (!stops.containsKey(stop.id())) {
            discovered.merge(new EffectorKey(stop.id(), stop.path()), stop, Confirmations::worse);
          }
        }
      }
    }
  }

  /** All but one may be forged. */
  private static EffectorStopResult worse(EffectorStopResult one, EffectorStopResult other) {
    return one.isConfirmed() ? other : one;
  }

  /**
   * The result of each effector that a configured phoenix reports, by its ID. Of several phoenixes,
   * one that does not confirm the stop counts.
   */
  Map<UUID, EffectorStopResult> stops() {
    return stops;
  }

  /**
   * Reports of discovered phoenixes about other effectors. Of several that give an effector the
   * same path, one that does not confirm the stop counts.
   */
  Collection<EffectorStopResult> discovered() {
    return discovered.values();
  }

  /** Groups whose last request their phoenix reports as unanswered. */
  List<UnconfirmedGroup> unconfirmed() {
    return unconfirmed;
  }

  /** Addresses where a phoenix may run that did not answer, as {@code host:port}. */
  List<String> unresponsive() {
    return addresses(answers.stream().filter(PhoenixAnswer::isUnresponsive).toList());
  }

  private static List<String> addresses(List<PhoenixAnswer> of) {
    return of.stream().map(each -> each.address().toString()).toList();
  }

  /** Whether a phoenix reports an effector that a lookup service lists. */
  boolean knows(UUID id, String path) {
    return stops.containsKey(id) || discovered.containsKey(new EffectorKey(id, path));
  }

  /**
   * Why the report of an effector's proxy does not count as its stop; empty if it counts, since no
   * phoenix knows its robot and no phoenix that may know it is unresponsive.
   *
   * @param robot name of the robot that the proxy is registered for
   */
  Optional<String> unconfirmedReason(String robot) {
    List<String> silent = unresponsive();
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

  /**
   * Why the report of phoenixes that were only discovered does not count as the stop of an
   * effector. It counts if
   *
   * <ul>
   *   <li>no configured phoenix has a robot of that name, and none is unresponsive,
   *   <li>a lookup service of such a phoenix's own computer lists the effector, and
   *   <li>for each lookup service that lists its identity, the phoenix of that computer confirms
   *       the stop too; or, if no phoenix with the robot runs there, the effector's proxy from
   *       there.
   * </ul>
   *
   * @param stop their report
   * @param listings of its identity, one for each lookup service that lists it
   * @return a clause; empty if it counts
   */
  Optional<String> unconfirmedReason(EffectorStopResult stop, List<StopMerge.ProxyClaim> listings) {
    return contradiction(stop, listings)
        .map(
            contradiction ->
                "phoenix at "
                    + answers.stream()
                        .filter(each -> each.confirms(stop.id(), stop.path()))
                        .map(each -> each.address().toString())
                        .collect(Collectors.joining(", "))
                    + ", which only discovery named, says that it is stopped, and "
                    + contradiction
                    + "; name its robot's phoenix with --phoenix or DFRA_PHOENIX");
  }

  private Optional<String> contradiction(
      EffectorStopResult stop, List<StopMerge.ProxyClaim> listings) {
    List<PhoenixAnswer> configured = answers.stream().filter(PhoenixAnswer::isConfigured).toList();
    if (configured.stream().anyMatch(each -> each.robots().contains(stop.robot()))) {
      return Optional.of("the configured phoenix of its robot does not");
    }
    List<PhoenixAnswer> silent = configured.stream().filter(PhoenixAnswer::isUnresponsive).toList();
    if (!silent.isEmpty()) {
      return Optional.of(
          "none of the configured ones answers at " + String.join(", ", addresses(silent)));
    }
    boolean isListedThere = false;
    for (StopMerge.ProxyClaim listing : listings) {
      List<PhoenixAnswer> there =
          answers.stream()
              .filter(each -> Objects.equals(each.address().host(), listing.host()))
              .toList();
      if (there.stream().anyMatch(each -> each.confirms(stop.id()))) {
        isListedThere |=
            listing.path().equals(stop.path())
                && there.stream().anyMatch(each -> each.confirms(stop.id(), stop.path()));
      } else if (there.stream()
          .anyMatch(each -> each.isUnresponsive() || each.robots().contains(listing.robot()))) {
        return Optional.of(
            "the phoenix at " + listing.host() + ", where it is listed too, does not");
      } else if (!listing.outcome().result().isWell()) {
        return Optional.of(
            "its proxy from another lookup service does not: " + listing.outcome().reason());
      }
    }
    return isListedThere
        ? Optional.empty()
        : Optional.of("no lookup service of that computer lists it");
  }

  /** Whether every effector and group that a phoenix knows has confirmed its stop. */
  boolean isComplete() {
    return unconfirmed.isEmpty()
        && stops.values().stream().allMatch(EffectorStopResult::isConfirmed)
        && discovered.values().stream().allMatch(EffectorStopResult::isConfirmed);
  }
}
