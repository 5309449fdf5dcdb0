package org.dfra.core.behavior;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.rmi.RemoteException;
import java.util.Objects;
import java.util.Optional;
import java.util.UUID;
import org.dfra.behavior.Behavior;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.Goal;
import org.dfra.core.chain.DelayedTaskExecutor;
import org.dfra.core.module.ModuleDependency;
import org.dfra.module.NotReadyException;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/**
 * A goal that one behaviour delegates to another, its worker.
 *
 * <p>If the worker cannot be reached to cancel the goal, or its answer was lost so that it is
 * unknown whether the goal has started, the cancellation is repeated every second until the worker
 * answers. The cancellation names the goal, so that a later goal of another client continues.
 *
 * <p>No parking brake is released for such a goal; see {@link Behavior#pursueUnattended}.
 *
 * @param <G> the worker's type of goals
 * @param <B> the worker's type
 */
public final class GoalDelegation<G extends Goal, B extends Behavior<G>> {

  private static final long RETRY_NANOS = 1_000_000_000;

  /**
   * A goal that the worker may still pursue though it is no longer wanted.
   *
   * @param goal its identity; null if the answer that carried it was lost
   * @param before the worker's previous goal; used if the identity is unknown
   */
  private record UnresolvedGoal<B>(B worker, @Nullable UUID goal, @Nullable UUID before) {

    /** The goal to cancel; null if the worker pursues none that was started here. */
    @Nullable UUID unwanted(BehaviorStatus now) {
      @Nullable UUID at = now.goal();
      boolean isOurs =
          now.phase().isUnderWay()
              && at != null
              && (goal == null ? !at.equals(before) : at.equals(goal));
      return isOurs ? at : null;
    }
  }

  /** Why the worker no longer pursues a goal that was not ended here. */
  public enum GoalLoss {
    /** It is not lost, as far as known. */
    NONE,
    /** The process that pursued it has died, and it was not stopped since. */
    DIED,
    /** The worker received another goal since. */
    REPLACED,
    /** The worker knows no goal, so it is unknown whether the goal was stopped. */
    FORGOTTEN
  }

  private final String path;
  private final ModuleDependency<B> needed;
  private final DelayedTaskExecutor taskExecutor;
  private final Logger log;

  @GuardedBy("this")
  private @Nullable B worker;

  @GuardedBy("this")
  private @Nullable UUID goal;

  @GuardedBy("this")
  private @Nullable UnresolvedGoal<B> unresolvedGoal;

  @GuardedBy("this")
  private GoalLoss loss = GoalLoss.NONE;

  /** Cancelled here while the worker did not answer. */
  @GuardedBy("this")
  private @Nullable UUID unresolved;

  // for an unresolved goal
  @GuardedBy("this")
  private boolean isRetryScheduled;

  /**
   * @param path path of the delegating behaviour, for messages
   * @param needed finds the worker
   * @param taskExecutor the task executor of the delegating behaviour
   */
  public GoalDelegation(
      String path, ModuleDependency<B> needed, DelayedTaskExecutor taskExecutor, Logger log) {
    this.path = path;
    this.needed = needed;
    this.taskExecutor = taskExecutor;
    this.log = log;
  }

  /**
   * Starts the goal on the worker.
   *
   * @throws org.dfra.behavior.GoalRefusedException if the worker refuses it, or is {@link
   *     org.dfra.behavior.GoalRefusedException#isBusy busy}
   * @throws DelegateHeldException if the previous goal was stopped, or may have been, while the
   *     worker was unreachable; thrown once
   * @throws RemoteException if the worker does not answer; it may have started the goal
   *     nevertheless, and {@link #cancel} cancels it
   */
  public synchronized void start(G wanted) throws RemoteException {
    B chosen = needed.resolve();
    BehaviorStatus found = chosen.status();
    @Nullable UUID before = found.goal();
    requireNotHeld(found);
    try {
      goal = chosen.pursueUnattended(wanted);
    } catch (RemoteException e) {
      unresolvedGoal = new UnresolvedGoal<>(chosen, null, before);
      throw e;
    }
    worker = chosen;
    unresolvedGoal = null;
    loss = GoalLoss.NONE;
  }

  @GuardedBy("this")
  private void requireNotHeld(BehaviorStatus found) {
    @Nullable UnresolvedGoal<B> lost = unresolvedGoal;
    @Nullable UUID left = unresolved;
    unresolved = null;
    boolean isOurs =
        left != null
            ? left.equals(found.goal())
            : lost != null && lost.goal() == null && !Objects.equals(found.goal(), lost.before());
    boolean isHeld = isOurs && found.heldSince() != null;
    if (isHeld || (left != null && found.goal() == null)) {
      throw new DelegateHeldException(
          path
              + (isHeld
                  ? ": what it uses was stopped while it did not answer: " + found.activity()
                  : ": what it uses lost its goal, so it is not known whether it was stopped"));
    }
  }

  /**
   * Adopts a goal that an earlier process of the delegating behaviour started, if the current best
   * worker still pursues it.
   *
   * @param begun the value of {@link #goal} at that time
   * @return whether it was adopted; it is then treated as if it had been started here
   * @throws RemoteException if the worker does not answer; the result is then unknown
   * @throws NotReadyException if there is no worker; the result is then unknown too
   */
  public synchronized boolean adopt(UUID begun) throws RemoteException {
    return adopt(begun, false);
  }

  /**
   * The same, also if the worker has ended it meanwhile, and has started no other goal since: then
   * {@link #status} returns the outcome.
   */
  public synchronized boolean adoptWithOutcome(UUID begun) throws RemoteException {
    return adopt(begun, true);
  }

  @GuardedBy("this")
  private boolean adopt(UUID begun, boolean isEndedWanted) throws RemoteException {
    B chosen = needed.resolve();
    BehaviorStatus status = chosen.status();
    loss = loss(begun, status);
    if (loss != GoalLoss.NONE || !(isEndedWanted || status.phase().isUnderWay())) {
      return false;
    }
    worker = chosen;
    goal = begun;
    return true;
  }

  /**
   * Cancels a goal that an earlier process of the delegating behaviour started, as soon as the
   * worker answers; asynchronously.
   */
  public void abandon(UUID begun) {
    taskExecutor.execute(
        () -> {
          try {
            needed.resolve().cancelUnattended(begun);
          } catch (RemoteException | NotReadyException e) {
            log.debug("{}: {} cannot be given up yet: {}", path, begun, e.toString());
            taskExecutor.schedule(RETRY_NANOS, () -> abandon(begun));
          }
        });
  }

  /** The identity of the delegated goal; empty if there is none, as far as known here. */
  public synchronized Optional<UUID> goal() {
    return Optional.ofNullable(goal);
  }

  /** Whether the worker may still pursue an unwanted goal; the cancellation is then repeated. */
  public synchronized boolean isUnresolved() {
    return unresolvedGoal != null;
  }

  /**
   * The worker's status.
   *
   * @return empty if the goal was not started, was ended here, or was lost: {@link #loss} gives the
   *     reason
   */
  public synchronized Optional<BehaviorStatus> status() throws RemoteException {
    @Nullable B by = worker;
    @Nullable UUID wanted = goal;
    if (by == null || wanted == null) {
      return Optional.empty();
    }
    BehaviorStatus status = status(by);
    loss = loss(wanted, status);
    if (loss != GoalLoss.NONE) {
      forget();
      return Optional.empty();
    }
    return Optional.of(status);
  }

  /** The status from the worker's next process, if its proxy does not find that automatically. */
  @GuardedBy("this")
  private BehaviorStatus status(B by) throws RemoteException {
    try {
      return by.status();
    } catch (NotReadyException e) {
      B next = next(e);
      if (next.equals(by)) {
        throw e;
      }
      BehaviorStatus status = next.status();
      worker = next;
      return status;
    }
  }

  /**
   * The currently available worker; throws {@code why} if there is none, since it explains more.
   */
  private B next(NotReadyException why) throws RemoteException {
    try {
      return needed.resolve();
    } catch (NotReadyException e) {
      why.addSuppressed(e);
      throw why;
    }
  }

  private static GoalLoss loss(UUID wanted, BehaviorStatus status) {
    if (status.goal() == null) {
      return GoalLoss.FORGOTTEN;
    }
    if (!wanted.equals(status.goal())) {
      return GoalLoss.REPLACED;
    }
    return status.phase() == BehaviorStatus.Phase.IDLE ? GoalLoss.DIED : GoalLoss.NONE;
  }

  /** Why {@link #status} or {@link #adopt} last found the goal no longer pursued. */
  public synchronized GoalLoss loss() {
    return loss;
  }

  /**
   * Changes a goal in progress.
   *
   * @param <B> the worker's type
   */
  @FunctionalInterface
  public interface Adjustment<B> {
    void apply(B worker, UUID goal) throws RemoteException;
  }

  /**
   * Changes the worker's goal without ending it.
   *
   * @return false if no goal is delegated
   * @throws RemoteException if the worker does not answer; it may have changed the goal
   *     nevertheless
   */
  public synchronized boolean adjust(Adjustment<? super B> change) throws RemoteException {
    @Nullable B by = worker;
    @Nullable UUID wanted = goal;
    if (by == null || wanted == null) {
      return false;
    }
    change.apply(by, wanted);
    return true;
  }

  /** Discards the goal after the worker has ended it. */
  public synchronized void forget() {
    goal = null;
  }

  /** Cancels the goal if the worker still pursues it. Never propagates the worker's exceptions. */
  public synchronized void cancel() {
    @Nullable B by = worker;
    @Nullable UUID wanted = goal;
    worker = null;
    goal = null;
    if (by != null && wanted != null) {
      unresolvedGoal = new UnresolvedGoal<>(by, wanted, null);
    }
    cut();
  }

  @GuardedBy("this")
  private void cut() {
    @Nullable UnresolvedGoal<B> left = unresolvedGoal;
    if (left == null) {
      return;
    }
    try {
      BehaviorStatus found = left.worker().status();
      @Nullable UUID unwanted = left.unwanted(found);
      if (unwanted != null) {
        left.worker().cancelUnattended(unwanted); // by name: it may have another goal by now
      }
      unresolvedGoal = null;
      if (found.heldSince() == null) {
        unresolved = null;
      }
    } catch (NotReadyException e) { // it has ended, and with it its leases
      unresolvedGoal = null;
      unresolved = left.goal();
    } catch (RemoteException e) {
      unresolved = left.goal();
      if (!isRetryScheduled) {
        isRetryScheduled = true;
        log.warn("{}: {} cannot be stopped yet: {}", path, left.worker(), e.toString());
        taskExecutor.schedule(RETRY_NANOS, this::again);
      }
    }
  }

  private synchronized void again() {
    isRetryScheduled = false;
    cut();
  }
}
