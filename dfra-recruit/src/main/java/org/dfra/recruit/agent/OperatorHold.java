package org.dfra.recruit.agent;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dfra.behavior.Behavior;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.core.host.CommandName;
import org.dfra.core.module.ModuleContext;
import org.dfra.directory.ModuleListing;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.persona.EmergencyStopAttributes;
import org.dfra.recruit.agent.OperatorHoldStore.HoldReason;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/**
 * Determines whether the robot is held: it was stopped, and no operator has ended the hold since. A
 * held robot answers no call for help and does not start a trip.
 *
 * <p>It is held by each of its behaviours whose goal is {@linkplain BehaviorStatus#heldSince held},
 * by each effector that moves it and was stopped for an emergency, released or not, and while it is
 * unknown whether its last trip was stopped. The behaviours and effectors store their stops
 * persistently. This class stores the stops that an operator has handled: by a goal that started
 * later, or by {@link #end}. So it also finds a stop that occurred while the agent's process was
 * down.
 *
 * <p>A new process discovers the robot's modules one after the other. Until it has queried all
 * known behaviours and found all effectors of the robot, it is unknown whether one of them was
 * stopped: the agent moves nothing until the hold is {@linkplain #isSettled settled}. If an earlier
 * version stored no modules, it searches for {@link #SETTLING}.
 *
 * <p>Thread-safe. Queries need no network, except {@link #queryBehaviors}.
 */
final class OperatorHold {

  private static final String NEVER = "never";

  /** No stop of it was handled yet. */
  private static final String STOPPED = "stopped";

  /** Time for which a new process searches for the modules before it reports a missing one. */
  static final Duration SETTLING = Duration.ofSeconds(10);

  private final ModuleContext context;
  private final RobotStateMonitor robotState;
  private final Logger log;

  // with its content
  @GuardedBy("this")
  private final OperatorHoldStore memory;

  /** Work is to be resumed, and the robot's modules are unknown. */
  @GuardedBy("this")
  private boolean isUnlisted;

  // a behaviour that did not respond, by path
  @GuardedBy("this")
  private @Nullable String silent;

  @GuardedBy("this")
  private boolean isSettled;

  // before it was settled, see #end
  @GuardedBy("this")
  private boolean isLetGo;

  // when this process started to search for them
  @GuardedBy("this")
  private long startNanos;

  OperatorHold(ModuleContext context, RobotStateMonitor robotState, Logger log) {
    this.context = context;
    this.robotState = robotState;
    this.log = log;
    this.memory = new OperatorHoldStore(context, log);
  }

  /**
   * Loads the state of an earlier process; it is settled after the queries.
   *
   * @param isHeir whether an earlier process started or interrupted work
   */
  synchronized void recall(boolean isHeir) {
    startNanos = context.robotTime().nanos();
    memory.load();
    isUnlisted = isHeir && memory.modules().isEmpty();
  }

  /**
   * Updates the known behaviours and effectors. A new effector may have been stopped and released
   * long ago: that does not count, but an unreleased stop does.
   */
  synchronized void refresh() {
    boolean isNews = memory.add(listed());
    for (ModuleListing<?> mover : robotState.effectors()) {
      EmergencyStopAttributes stop = stopReason(mover);
      String known = stop.latched() ? STOPPED : text(stop.since());
      isNews |= memory.noteFirst(mover.path(), known);
    }
    Optional<HoldReason> now = live();
    @Nullable HoldReason last = memory.last();
    if (now.isPresent() && !now.get().equals(last)) {
      memory.last(now.get());
      isNews = true;
    } else if (now.isEmpty() && last != null && isFound(last.path())) {
      memory.last(null);
      isNews = true;
    }
    if (isNews) {
      memory.save();
    }
  }

  /** In a new process nothing is found at first. */
  @GuardedBy("this")
  private boolean isFound(String path) {
    return listed().contains(path);
  }

  private static EmergencyStopAttributes stopReason(ModuleListing<?> mover) {
    return mover
        .attributes(EmergencyStopAttributes.class)
        .orElseGet(() -> new EmergencyStopAttributes(false, null, null));
  }

  private static String text(@Nullable Instant since) {
    return since == null ? NEVER : since.toString();
  }

  private Set<String> listed() {
    return Stream.concat(robotState.effectors().stream(), robotState.behaviors().stream())
        .map(ModuleListing::path)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /** The reason of the hold, as a clause; empty where it is not held. */
  synchronized Optional<String> reason() {
    return stopReason().or(this::notSettled);
  }

  /** The stop that holds it, as a clause; empty where none is known. */
  synchronized Optional<String> stopReason() {
    return Optional.ofNullable(memory.unknown())
        .or(() -> live().map(HoldReason::why))
        .or(this::notFoundAgain);
  }

  /**
   * Whether this process has queried all known behaviours of the robot and found all of its
   * effectors, or an operator has ended the hold without that.
   */
  synchronized boolean isSettled() {
    return isSettled;
  }

  /** Queries the behaviours that this process has not queried yet. */
  void settle() {
    if (isSettled()) {
      return;
    }
    try {
      Optional<String> unused = queryBehaviors();
    } catch (RemoteException | NotReadyException e) {
      log.debug("{}: it is not known yet whether the robot was stopped", context.path(), e);
    }
  }

  /** After the timeout it reports what is missing. */
  @GuardedBy("this")
  private Optional<String> notSettled() {
    if (isSettled || isLetGo || !isOverdue()) {
      return Optional.empty();
    }
    Set<String> missing = missing();
    if (!missing.isEmpty()) {
      return Optional.of(
          "the agent was restarted and does not find "
              + String.join(", ", missing)
              + ", so it is unknown whether the robot was stopped; if that was removed, end the hold"
              + " with "
              + CommandName.current()
              + " recruit resume "
              + context.robot());
    }
    return Optional.ofNullable(silent) // otherwise it is settled at the next query
        .map(
            path ->
                path
                    + " does not answer the restarted agent, so it is unknown whether the robot was"
                    + " stopped; if its computer can be reached, restart its service group with"
                    + " "
                    + CommandName.current()
                    + " module kill "
                    + path);
  }

  @GuardedBy("this")
  private boolean isOverdue() {
    return context.robotTime().nanos() - startNanos >= SETTLING.toNanos();
  }

  @GuardedBy("this")
  private Set<String> missing() {
    Set<String> missing = new TreeSet<>(memory.modules());
    missing.removeAll(listed());
    return missing;
  }

  /** The module that held it is not found now, as at first in a new process. */
  @GuardedBy("this")
  private Optional<String> notFoundAgain() {
    @Nullable HoldReason before = memory.last();
    return before == null || isFound(before.path()) ? Optional.empty() : Optional.of(before.why());
  }

  @GuardedBy("this")
  private Optional<HoldReason> live() {
    Optional<HoldReason> stopped = byEffector();
    if (stopped.isPresent()) {
      return stopped;
    }
    for (ModuleListing<?> each : robotState.behaviors()) {
      Optional<HoldReason> held = byBehavior(each, robotState.heldSince(each));
      if (held.isPresent()) {
        return held;
      }
    }
    return Optional.empty();
  }

  @GuardedBy("this")
  private Optional<HoldReason> byEffector() {
    for (ModuleListing<?> mover : robotState.effectors()) {
      EmergencyStopAttributes stop = stopReason(mover);
      String path = mover.path();
      if (stop.latched()) {
        return Optional.of(new HoldReason(path, path + " is stopped for an emergency"));
      }
      String since = text(stop.since());
      @Nullable String before = memory.endedStop(path);
      if (before != null && !before.equals(since)) {
        return Optional.of(
            new HoldReason(path, path + " was stopped for an emergency, and released at " + since));
      }
    }
    return Optional.empty();
  }

  @GuardedBy("this")
  private Optional<HoldReason> byBehavior(ModuleListing<?> behavior, @Nullable Instant since) {
    String path = behavior.path();
    return since == null || since.toString().equals(memory.endedStop(path))
        ? Optional.empty()
        : Optional.of(
            new HoldReason(path, "an operator or a program stopped " + path + " at " + since));
  }

  /**
   * The same, from a query of each behaviour of the robot now: before a call moves anything.
   *
   * @throws RemoteException if one does not respond, so that the result is unknown
   * @throws NotReadyException if one has ended, or this new process has not found all of them yet,
   *     so that the result is unknown, too
   */
  Optional<String> queryBehaviors() throws RemoteException {
    try {
      Optional<String> held = askEach();
      if (held.isPresent()) {
        return held;
      }
    } catch (RemoteException | NotReadyException e) {
      synchronized (this) {
        Optional<String> obstacle = notSettled();
        if (obstacle.isEmpty()) {
          throw e;
        }
        return obstacle;
      }
    }
    synchronized (this) {
      return Optional.ofNullable(memory.unknown())
          .or(() -> byEffector().map(HoldReason::why))
          .or(this::notFoundAgain);
    }
  }

  private Optional<String> askEach() throws RemoteException {
    Set<String> asked = new TreeSet<>();
    robotState
        .effectors()
        .forEach(each -> asked.add(each.path())); // their personas give their state
    for (ModuleListing<? extends Behavior<?>> each : robotState.behaviors()) {
      @Nullable Instant since = answer(each).heldSince();
      asked.add(each.path());
      Optional<String> held;
      synchronized (this) {
        held = byBehavior(each, since).map(HoldReason::why);
      }
      if (held.isPresent()) {
        return held;
      }
    }
    synchronized (this) {
      boolean isTime = !isLetGo && (!isUnlisted || isOverdue());
      isSettled |= isTime && asked.containsAll(memory.modules());
      silent = null;
      if (!isSettled) {
        throw new NotReadyException(context.path(), Readiness.INITIALIZING, unsettled());
      }
    }
    return Optional.empty();
  }

  private BehaviorStatus answer(ModuleListing<? extends Behavior<?>> behavior)
      throws RemoteException {
    try {
      return behavior.module().status();
    } catch (RemoteException | NotReadyException e) {
      synchronized (this) {
        silent = behavior.path();
      }
      throw e;
    }
  }

  /** The reason why it is not settled now, as a clause. */
  @GuardedBy("this")
  private String unsettled() {
    Set<String> missing = missing();
    return missing.isEmpty()
        ? "it has not found all modules yet that may have been stopped"
        : "it does not find " + String.join(", ", missing) + " yet";
  }

  /**
   * The last stop of an effector that an operator has handled, or the first one seen; null for
   * none.
   */
  synchronized @Nullable String lastStop(String path) {
    return memory.endedStop(path);
  }

  /** It is unknown whether its trip was stopped; it is held until an operator ends the hold. */
  synchronized void setUnknown(String why) {
    memory.unknown(why);
    memory.save();
  }

  /**
   * An operator started, or resumed, a goal at that time: this ends each earlier hold.
   *
   * @param by behaviour that executes it
   */
  synchronized void endedByGoal(String by, Instant time) {
    if (reason().isPresent() && end(time)) {
      log.info("{}: the hold has ended, since {} has a goal", context.path(), by);
    }
  }

  /**
   * An operator ends the hold. An unreleased emergency stop still holds it. If it was not settled,
   * work may wait for that, and it stays unsettled until {@link #settleByPerson}.
   */
  synchronized void end() {
    isLetGo |= !isSettled;
    memory.retain(listed());
    boolean unused = end(Instant.MAX);
    memory.save();
    log.info(
        "{}: an operator ended the hold; now: {}", context.path(), reason().orElse("not held"));
  }

  /** The waiting work was cancelled: ending the hold moves nothing. */
  synchronized void settleByPerson() {
    isSettled = true;
  }

  private synchronized boolean end(Instant until) {
    String before = memory.text();
    memory.unknown(null);
    memory.last(null);
    for (ModuleListing<?> mover : robotState.effectors()) {
      EmergencyStopAttributes stop = stopReason(mover);
      if (!stop.latched() && !isAfter(stop.since(), until)) {
        memory.setEndedStop(mover.path(), text(stop.since()));
      }
    }
    for (ModuleListing<?> each : robotState.behaviors()) {
      @Nullable Instant since = robotState.heldSince(each);
      if (since != null && !isAfter(since, until)) {
        memory.setEndedStop(each.path(), since.toString());
      }
    }
    boolean isNews = !before.equals(memory.text());
    if (isNews) {
      memory.save();
    }
    return isNews;
  }

  private static boolean isAfter(@Nullable Instant since, Instant until) {
    return since != null && since.isAfter(until);
  }
}
