package org.dfra.recruit.agent;

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
import org.dfra.core.module.ModuleContext;
import org.dfra.directory.ModuleListing;
import org.dfra.module.NotReadyException;
import org.dfra.module.Readiness;
import org.dfra.persona.EmergencyStopAttributes;
import org.dfra.recruit.agent.OperatorHoldStore.HoldReason;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/**
 * Whether the robot is held: somebody stopped it, and nobody has let it go on since. A robot that
 * is held answers no call for help, and does not set out.
 *
 * <p>It is held by each of its behaviours whose goal is {@linkplain BehaviorStatus#heldSince held},
 * by each effector that moves it and was stopped for an emergency, released or not, and where it is
 * not known whether somebody stopped its last trip. The behaviours and effectors remember their
 * stops themselves, over the death of their processes. What is written down here are the stops that
 * a person has dealt with: by a goal that began later, or by {@link #end}. So a stop is found also
 * where it happened while the agent's process was dead.
 *
 * <p>A new process finds the robot's modules one after the other. As long as it has not asked all
 * of the behaviours that the robot is known to have, and seen all of its effectors, nobody knows
 * whether somebody stopped one of them: nothing moves for it until it is {@linkplain #isSettled
 * settled}. Where an earlier version wrote down none of them, it looks for {@link #SETTLING}.
 *
 * <p>Thread-safe. Asking needs no network, but for {@link #queryBehaviors}.
 */
final class OperatorHold {

  private static final String NEVER = "never";

  /** No stop of it was dealt with yet. */
  private static final String STOPPED = "stopped";

  /** For how long a new process looks for the modules before it says that one is missing. */
  static final Duration SETTLING = Duration.ofSeconds(10);

  private final ModuleContext context;
  private final RobotStateMonitor senses;
  private final Logger log;
  private final OperatorHoldStore memory; // guarded by this, with all that is in it

  /** Guarded by this; something is to go on, and nobody knows which modules the robot has. */
  private boolean isUnlisted;

  private @Nullable String silent; // guarded by this; a behaviour that did not answer, by path
  private boolean isSettled; // guarded by this
  private boolean isLetGo; // guarded by this; before it was settled, see #end
  private long startNanos; // guarded by this; when this process began to look for them

  OperatorHold(ModuleContext context, RobotStateMonitor senses, Logger log) {
    this.context = context;
    this.senses = senses;
    this.log = log;
    this.memory = new OperatorHoldStore(context, log);
  }

  /**
   * Knows again what an earlier process has written down; it is settled when it has asked.
   *
   * @param isHeir whether there is something that an earlier process began or left
   */
  synchronized void recall(boolean isHeir) {
    startNanos = context.robotTime().nanos();
    memory.load();
    isUnlisted = isHeir && memory.modules().isEmpty();
  }

  /**
   * Sees which behaviours and effectors there are. An effector that it sees for the first time may
   * have been stopped and released years ago: that does not count, but a stop that is not released
   * does.
   */
  synchronized void refresh() {
    boolean isNews = memory.add(listed());
    for (ModuleListing<?> mover : senses.effectors()) {
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

  /** Holds the lock. In a new process nothing is found at first. */
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
    return Stream.concat(senses.effectors().stream(), senses.behaviors().stream())
        .map(ModuleListing::path)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /** Why it is held, as a clause; nothing where it is not. */
  synchronized Optional<String> reason() {
    return stopReason().or(this::notSettled);
  }

  /** Which stop holds it, as a clause; nothing where none does, as far as is known. */
  synchronized Optional<String> stopReason() {
    return Optional.ofNullable(memory.unknown())
        .or(() -> live().map(HoldReason::why))
        .or(this::notFoundAgain);
  }

  /**
   * Whether this process has asked all the behaviours that the robot is known to have, and found
   * all of its effectors, or a person has let it go on without that.
   */
  synchronized boolean isSettled() {
    return isSettled;
  }

  /** Asks the behaviours where this process has not done that yet. */
  void settle() {
    if (isSettled()) {
      return;
    }
    try {
      Optional<String> unused = queryBehaviors();
    } catch (RemoteException | NotReadyException e) {
      log.debug("{}: it does not know yet whether somebody stopped it", context.path(), e);
    }
  }

  /** Holds the lock. It looks no longer without saying so. */
  private Optional<String> notSettled() {
    if (isSettled || isLetGo || !isOverdue()) {
      return Optional.empty();
    }
    Set<String> missing = missing();
    if (!missing.isEmpty()) {
      return Optional.of(
          "its agent's new process does not find "
              + String.join(", ", missing)
              + ", so nobody knows whether somebody stopped it; where that was removed, have it go"
              + " on by ./dfra recruit resume "
              + context.robot());
    }
    return Optional.ofNullable(silent) // otherwise it is settled as soon as it asks again
        .map(
            path ->
                path
                    + " does not answer its agent's new process, so nobody knows whether somebody"
                    + " stopped it; where its computer is in reach, have its group start anew there"
                    + " by ./dfra module kill "
                    + path);
  }

  /** Holds the lock. */
  private boolean isOverdue() {
    return context.robotTime().nanos() - startNanos >= SETTLING.toNanos();
  }

  /** Holds the lock. */
  private Set<String> missing() {
    Set<String> missing = new TreeSet<>(memory.modules());
    missing.removeAll(listed());
    return missing;
  }

  /** Holds the lock. What held it is not found now, as at first in a new process. */
  private Optional<String> notFoundAgain() {
    @Nullable HoldReason before = memory.last();
    return before == null || isFound(before.path()) ? Optional.empty() : Optional.of(before.why());
  }

  /** Holds the lock. */
  private Optional<HoldReason> live() {
    return byEffector()
        .or(
            () ->
                senses.behaviors().stream()
                    .flatMap(each -> byBehavior(each, senses.heldSince(each)).stream())
                    .findFirst());
  }

  /** Holds the lock. */
  private Optional<HoldReason> byEffector() {
    for (ModuleListing<?> mover : senses.effectors()) {
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

  /** Holds the lock. */
  private Optional<HoldReason> byBehavior(ModuleListing<?> behavior, @Nullable Instant since) {
    String path = behavior.path();
    return since == null || since.toString().equals(memory.endedStop(path))
        ? Optional.empty()
        : Optional.of(
            new HoldReason(path, "somebody or something stopped " + path + " at " + since));
  }

  /**
   * The same, by asking each behaviour of the robot now: before anything moves for a call.
   *
   * @throws RemoteException if one does not answer, so that it is not known
   * @throws NotReadyException if one has ended, or this is a new process that has not found all of
   *     them yet, so that it is not known either
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
    senses.effectors().forEach(each -> asked.add(each.path())); // their personas say how they are
    for (ModuleListing<? extends Behavior<?>> each : senses.behaviors()) {
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

  /** Holds the lock. Why it is not settled now, as a clause. */
  private String unsettled() {
    Set<String> missing = missing();
    return missing.isEmpty()
        ? "it does not know yet whether it has found all that may have been stopped"
        : "it does not find " + String.join(", ", missing) + " yet";
  }

  /** The last stop of an effector that a person has dealt with, or it first saw; null for none. */
  synchronized @Nullable String lastStop(String path) {
    return memory.endedStop(path);
  }

  /** Nobody knows whether somebody stopped its trip; it is held until a person lets it go on. */
  synchronized void setUnknown(String why) {
    memory.unknown(why);
    memory.save();
  }

  /**
   * A person had a goal begin, or go on, at that time: that ends each hold that was before.
   *
   * @param by what pursues it
   */
  synchronized void endedByGoal(String by, Instant time) {
    if (reason().isPresent() && end(time)) {
      log.info("{}: it is held no more, since {} has a goal", context.path(), by);
    }
  }

  /**
   * A person lets it go on. An emergency stop that is not released holds it nevertheless. Where it
   * was not settled, something may wait for that, and it stays so until {@link #settleByPerson}.
   */
  synchronized void end() {
    isLetGo |= !isSettled;
    memory.retain(listed());
    boolean unused = end(Instant.MAX);
    memory.save();
    log.info("{}: a person lets it go on; now: {}", context.path(), reason().orElse("not held"));
  }

  /** What waited for it has been given up: the person who let it go on moves nothing by that. */
  synchronized void settleByPerson() {
    isSettled = true;
  }

  private synchronized boolean end(Instant until) {
    String before = memory.text();
    memory.unknown(null);
    memory.last(null);
    for (ModuleListing<?> mover : senses.effectors()) {
      EmergencyStopAttributes stop = stopReason(mover);
      if (!stop.latched() && !isAfter(stop.since(), until)) {
        memory.setEndedStop(mover.path(), text(stop.since()));
      }
    }
    for (ModuleListing<?> each : senses.behaviors()) {
      @Nullable Instant since = senses.heldSince(each);
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
