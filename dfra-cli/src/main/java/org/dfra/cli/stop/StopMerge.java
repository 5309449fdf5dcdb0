package org.dfra.cli.stop;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.function.Supplier;
import org.dfra.cli.stop.Outcome.Result;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.river.phoenix.stop.EffectorStopResult;
import org.dfra.river.phoenix.stop.UnconfirmedGroup;
import org.jspecify.annotations.Nullable;

/**
 * Combines all answers into the outcome for each effector. An effector counts as stopped when its
 * phoenix confirms it, by either path to it. The report of a listed proxy counts only for robots
 * that no phoenix knows: any client may have registered it. For the report of a phoenix that was
 * only discovered see {@link Confirmations#unconfirmedReason(EffectorStopResult, List)}.
 */
final class StopMerge {

  private final String by;
  private final Supplier<Duration> running;

  /**
   * @param by the requester, as effectors store it
   * @param running for how long the command has run
   */
  StopMerge(String by, Supplier<Duration> running) {
    this.by = by;
    this.running = running;
  }

  /**
   * The report of a listed proxy.
   *
   * @param id the effector's ID
   * @param path {@code robot/name}
   * @param host the claimed host of the lookup service; null if unknown
   * @param outcome for the effector
   */
  record ProxyClaim(UUID id, String path, @Nullable String host, Outcome outcome) {

    /** Name of its robot. */
    String robot() {
      return robotOf(path);
    }

    /** The other one if this one is successful. */
    ProxyClaim orWorse(ProxyClaim other) {
      return outcome.result().isWell() ? other : this;
    }
  }

  /**
   * Name of an effector's robot.
   *
   * @param path {@code robot/name}
   */
  static String robotOf(String path) {
    int slash = path.indexOf('/');
    return slash < 0 ? "" : path.substring(0, slash);
  }

  /**
   * The outcome for an effector by its phoenix's report. The report contains the duration of the
   * stop: the effector was stopped already if another requester did it, or if it is older than this
   * command.
   */
  Outcome ofPhoenix(EffectorStopResult stop) {
    @Nullable EmergencyStopState state = stop.state();
    if (state == null) {
      return new Outcome(stop.path(), Result.NOT_STOPPED, null, null, stop.fault());
    }
    boolean isAnothers = stop.wasStopped() && !by.equals(state.requester());
    return Outcome.ofStop(stop.path(), isAnothers ? Duration.ZERO : running.get(), state);
  }

  /**
   * All outcomes.
   *
   * @param claimed reports of proxies, one for each lookup service; of several with one ID and
   *     path, an unsuccessful one counts: all but one may be forged
   * @param local by path, reports of this host's effectors that its phoenix's administrator reached
   * @param confirmations reports of phoenixes
   */
  List<Outcome> merge(
      List<ProxyClaim> claimed, Map<String, List<Outcome>> local, Confirmations confirmations) {
    Map<String, List<Outcome>> here = new LinkedHashMap<>(local);
    Map<UUID, ProxyClaim> byIdentity = new LinkedHashMap<>();
    Map<UUID, List<ProxyClaim>> listings = new HashMap<>();
    Map<String, ProxyClaim> claims = new LinkedHashMap<>();
    for (ProxyClaim claim : claimed) {
      listings.computeIfAbsent(claim.id(), unused -> new ArrayList<>()).add(claim);
      byIdentity.merge(claim.id(), claim, ProxyClaim::orWorse);
      claims.merge(claim.id() + " " + claim.path(), claim, ProxyClaim::orWorse);
    }
    List<Outcome> outcomes = new ArrayList<>();
    confirmations
        .stops()
        .values()
        .forEach(stop -> outcomes.add(known(stop, byIdentity.get(stop.id()), here)));
    for (EffectorStopResult stop : confirmations.discovered()) {
      Optional<Outcome> uncertain =
          ofPhoenix(stop).result().isWell()
              ? confirmations
                  .unconfirmedReason(stop, listings.getOrDefault(stop.id(), List.of()))
                  .map(why -> doubtful(ofPhoenix(stop), why))
              : Optional.empty();
      outcomes.add(uncertain.orElseGet(() -> known(stop, byIdentity.get(stop.id()), here)));
    }
    for (ProxyClaim claim : claims.values()) {
      if (!confirmations.knows(claim.id(), claim.path())) {
        outcomes.add(unknown(claim, here, confirmations));
      }
    }
    here.values().forEach(outcomes::addAll);
    for (UnconfirmedGroup group : confirmations.unconfirmed()) {
      if (outcomes.stream().noneMatch(each -> isOpen(each, group.robot()))) {
        outcomes.add(
            new Outcome(
                group.robot() + "/ (group " + group.group() + ")",
                Result.UNCONFIRMED,
                null,
                null,
                group.reason()));
      }
    }
    return outcomes;
  }

  /** Whether an outcome already reports a failure of an effector of the robot. */
  private static boolean isOpen(Outcome outcome, String robot) {
    return !outcome.result().isWell() && outcome.module().startsWith(robot + "/");
  }

  /** An effector that a phoenix knows. */
  private Outcome known(
      EffectorStopResult stop, @Nullable ProxyClaim claim, Map<String, List<Outcome>> here) {
    Outcome outcome = ofPhoenix(stop);
    Optional<Outcome> other = only(stop.path(), here);
    if (outcome.result().isWell()) {
      return outcome;
    } else if (other.isPresent() && other.get().result().isWell()) {
      return other.get();
    } else if (stop.state() == null && claim != null && claim.outcome().result().isWell()) {
      return doubtful(
          claim.outcome(),
          "its proxy says that it is stopped, and its phoenix does not confirm that: "
              + stop.fault());
    }
    return outcome;
  }

  /** An effector that no phoenix knows. */
  private static Outcome unknown(
      ProxyClaim claim, Map<String, List<Outcome>> here, Confirmations confirmations) {
    Outcome outcome = claim.outcome();
    Optional<Outcome> other = only(claim.path(), here);
    if (other.isPresent() && other.get().result().isWell()) {
      return outcome.result().isWell() ? outcome : other.get();
    } else if (!outcome.result().isWell()) {
      return outcome;
    }
    return confirmations
        .unconfirmedReason(claim.robot())
        .map(why -> doubtful(outcome, why))
        .orElse(outcome);
  }

  /** Removes the only outcome with that path; several of one name are several effectors. */
  private static Optional<Outcome> only(String path, Map<String, List<Outcome>> here) {
    @Nullable List<Outcome> all = here.get(path);
    if (all == null || all.size() != 1) {
      return Optional.empty();
    }
    here.remove(path);
    return Optional.of(all.get(0));
  }

  private static Outcome doubtful(Outcome claimed, String why) {
    return new Outcome(
        claimed.module(), Result.UNCONFIRMED, claimed.requester(), claimed.since(), why);
  }
}
