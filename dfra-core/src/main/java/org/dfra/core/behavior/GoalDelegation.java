package org.dfra.core.behavior;

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
 * A goal of one behaviour that another pursues for it.
 *
 * <p>Where the other cannot be reached to give it up, or its answer was lost so that nobody knows
 * whether it has begun, it is asked again every second until it has answered. What it gives up is
 * named, so that a goal that somebody else has it pursue since goes on.
 *
 * <p>No parking brake is released for such a goal; see {@link Behavior#pursueUnattended}.
 *
 * @param <G> what the other can reach
 * @param <B> the other's kind
 */
public final class GoalDelegation<G extends Goal, B extends Behavior<G>> {

  private static final long RETRY_NANOS = 1_000_000_000;

  /**
   * What may still be pursued though nobody wants it.
   *
   * @param goal its name; null where the answer that told it was lost
   * @param before what the other was at before; counts where the name is not known
   */
  private record UnresolvedGoal<B>(B worker, @Nullable UUID goal, @Nullable UUID before) {

    /** What is to be given up; null where the other is at nothing that was begun here. */
    @Nullable UUID unwanted(BehaviorStatus now) {
      @Nullable UUID at = now.goal();
      boolean isOurs =
          now.phase().isUnderWay()
              && at != null
              && (goal == null ? !at.equals(before) : at.equals(goal));
      return isOurs ? at : null;
    }
  }

  /** Why what was begun here is not pursued any more, though nobody here has ended it. */
  public enum GoalLoss {
    /** It is not lost, as far as is known. */
    NONE,
    /** The process that pursued it has died, and nobody has stopped it since. */
    DIED,
    /** The other was given another goal since. */
    REPLACED,
    /** The other knows of no goal, so nobody can tell whether somebody has stopped it. */
    FORGOTTEN
  }

  private final String path;
  private final ModuleDependency<B> needed;
  private final DelayedTaskExecutor errands;
  private final Logger log;
  private @Nullable B worker; // guarded by this
  private @Nullable UUID goal; // guarded by this
  private @Nullable UnresolvedGoal<B> unresolvedGoal; // guarded by this
  private GoalLoss loss = GoalLoss.NONE; // guarded by this

  /** Was ended here while the other did not answer; guarded by this. */
  private @Nullable UUID unresolved;

  private boolean isRetryScheduled; // guarded by this; that something is loose

  /**
   * @param path of the behaviour that delegates, for messages
   * @param needed who can do it
   * @param errands of the behaviour that delegates
   */
  public GoalDelegation(
      String path, ModuleDependency<B> needed, DelayedTaskExecutor errands, Logger log) {
    this.path = path;
    this.needed = needed;
    this.errands = errands;
    this.log = log;
  }

  /**
   * Has it pursued.
   *
   * @throws org.dfra.behavior.GoalRefusedException if the other does not take it up, or is {@link
   *     org.dfra.behavior.GoalRefusedException#isBusy busy}
   * @throws DelegateHeldException if somebody stopped what was begun here before, or may have,
   *     while the other could not be asked; once
   * @throws RemoteException if the other does not answer; it may have taken it up nevertheless, and
   *     {@link #cancel} has it give that up
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
                  : ": what it uses forgot its goal, so nobody knows whether somebody stopped it"));
    }
  }

  /**
   * Takes over what an earlier process of the one that delegates has begun, if the best there is
   * now is still at it.
   *
   * @param begun as {@link #goal} was then
   * @return whether it is; from then on it is as if it had been begun here
   * @throws RemoteException if the other does not answer; then nobody knows
   * @throws NotReadyException if there is none; then nobody knows either
   */
  public synchronized boolean adopt(UUID begun) throws RemoteException {
    return adopt(begun, false);
  }

  /**
   * The same, also where the other has ended it meanwhile, and has begun nothing else since: then
   * {@link #status} says how.
   */
  public synchronized boolean adoptWithOutcome(UUID begun) throws RemoteException {
    return adopt(begun, true);
  }

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
   * Has the other give up what an earlier process of the one that delegates has begun, as soon as
   * it answers; beside whatever calls this.
   */
  public void abandon(UUID begun) {
    errands.execute(
        () -> {
          try {
            needed.resolve().cancelUnattended(begun);
          } catch (RemoteException | NotReadyException e) {
            log.debug("{}: {} cannot be given up yet: {}", path, begun, e.toString());
            errands.schedule(RETRY_NANOS, () -> abandon(begun));
          }
        });
  }

  /** What is pursued for it, by name; nothing where nothing is, as far as is known here. */
  public synchronized Optional<UUID> goal() {
    return Optional.ofNullable(goal);
  }

  /** Whether the other may still be at what nobody wants any more; it is told again then. */
  public synchronized boolean isUnresolved() {
    return unresolvedGoal != null;
  }

  /**
   * How far the other is.
   *
   * @return nothing where it has not begun, has ended here, or was lost: {@link #loss} says how
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

  /** Of the next process of the other, where its proxy does not find that by itself. */
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

  /** Whatever can do it now; where nothing can, {@code why} tells more than that does. */
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

  /** Why {@link #status}, or the adopting, found last what was begun here not pursued any more. */
  public synchronized GoalLoss loss() {
    return loss;
  }

  /**
   * Changes what is pursued, while it is.
   *
   * @param <B> the other's kind
   */
  @FunctionalInterface
  public interface Adjustment<B> {
    void apply(B worker, UUID goal) throws RemoteException;
  }

  /**
   * Has the other change what it pursues, without ending it.
   *
   * @return false where nothing is pursued for it
   * @throws RemoteException if the other does not answer; it may have changed it nevertheless
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

  /** The other has ended it. */
  public synchronized void forget() {
    goal = null;
  }

  /** Has the other give it up, if it is still at it. Never throws what the other throws. */
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

  /** Holds the lock. */
  private void cut() {
    @Nullable UnresolvedGoal<B> left = unresolvedGoal;
    if (left == null) {
      return;
    }
    try {
      BehaviorStatus found = left.worker().status();
      @Nullable UUID unwanted = left.unwanted(found);
      if (unwanted != null) {
        left.worker()
            .cancelUnattended(unwanted); // by name: somebody else may have it pursue another by now
      }
      unresolvedGoal = null;
      if (found.heldSince() == null) {
        unresolved = null;
      }
    } catch (NotReadyException e) { // it has ended, and all that it commanded with it
      unresolvedGoal = null;
      unresolved = left.goal();
    } catch (RemoteException e) {
      unresolved = left.goal();
      if (!isRetryScheduled) {
        isRetryScheduled = true;
        log.warn("{}: {} cannot be told to stop yet: {}", path, left.worker(), e.toString());
        errands.schedule(RETRY_NANOS, this::again);
      }
    }
  }

  private synchronized void again() {
    isRetryScheduled = false;
    cut();
  }
}
