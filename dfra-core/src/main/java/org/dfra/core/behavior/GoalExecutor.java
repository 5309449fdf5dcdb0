package org.dfra.core.behavior;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.rmi.RemoteException;
import java.util.EnumSet;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.core.behavior.BehaviorImpl.RequestedBy;
import org.dfra.core.behavior.BehaviorStatusTracker.Completion;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/**
 * Executes a behaviour's goals, one at a time: its control loop executes a step of the goal's
 * {@link GoalExecution} in every cycle, and the step's result makes the transitions of {@link
 * Phase}.
 *
 * <p>A module that does not answer may block a cycle. Callers do not wait long for it: a request to
 * stop takes effect at once, and the cycle suspends the goal at its end.
 *
 * <p>Threads: the loop's own, from the first goal to {@link #close}.
 */
final class GoalExecutor implements AutoCloseable {

  /** Maximum wait for a cycle in progress: less than a call's deadline. */
  private static final long CYCLE_TIMEOUT_MILLIS = 1000;

  /** Starts a goal. */
  @FunctionalInterface
  interface GoalStarter {

    /** See {@link BehaviorImpl#startGoal} and {@link BehaviorImpl#prepare}. */
    GoalExecution begin() throws RemoteException;
  }

  private final String path;
  private final Logger log;
  private final Consumer<Throwable> faults;
  private final ControlLoop loop;

  /** Held during every cycle and while a goal is started; other modules are called under it. */
  private final ReentrantLock cycling = new ReentrantLock();

  // the last that was started
  @GuardedBy("cycling")
  private @Nullable GoalExecution execution;

  @GuardedBy("cycling")
  private boolean isSuspended;

  /** Its lock is taken after {@link #cycling}. */
  private final BehaviorStatusTracker status;

  private volatile boolean isOver;

  /**
   * @param path path of the behaviour, for messages
   * @param rate cycles per second, hertz
   * @param status the behaviour's status, which only this object changes
   * @param faults receives unexpected exceptions of an execution
   */
  GoalExecutor(
      String path,
      Scheduler time,
      double rate,
      BehaviorStatusTracker status,
      Logger log,
      Consumer<Throwable> faults) {
    this.path = path;
    this.status = status;
    this.log = log;
    this.faults = faults;
    this.loop = new ControlLoop("dfra-behavior " + path, time, rate, this::cycle);
  }

  /** See {@link ControlLoop#lateness}. */
  double lateness(double share) {
    return loop.lateness(share);
  }

  /** Cycles that were missed because earlier ones took too long. */
  long missedCycles() {
    return loop.missedCycles();
  }

  /** Whether it executes no more goals. */
  boolean isClosed() {
    return isOver;
  }

  /**
   * Starts a goal.
   *
   * @param requireReady throws if the behaviour accepts no goals now
   * @return its identity
   * @throws GoalRefusedException if there is one already, or a cycle is blocked
   */
  UUID accept(Runnable requireReady, GoalStarter goal) throws RemoteException {
    if (!await(cycling)) {
      throw GoalRefusedException.busy(
          path + " waits for a module that does not answer; ask again in a few seconds");
    }
    try {
      requireReady.run();
      if (status.phase().isUnderWay()) {
        throw GoalRefusedException.busy(
            path
                + " pursues another goal ("
                + status.status().activity()
                + "); cancel that first, or wait for its end");
      }
      return begin(goal.begin(), Phase.RUNNING, "it begins", Completion.NONE);
    } finally {
      cycling.unlock();
    }
  }

  /** Restores a goal that an earlier process started. */
  void restore(GoalExecution begun, Phase phase, Completion before) {
    cycling.lock();
    try {
      UUID unused = begin(begun, phase, "it was begun before this process", before);
    } finally {
      cycling.unlock();
    }
  }

  @GuardedBy("cycling")
  private UUID begin(GoalExecution begun, Phase phase, String doing, Completion extent) {
    UUID id = UUID.randomUUID();
    status.begin(id, phase, doing, extent);
    execution = begun;
    isSuspended = true;
    if (phase == Phase.RUNNING) {
      loop.start();
    }
    return id;
  }

  /**
   * Resumes a paused goal.
   *
   * @param requester a program can only resume a goal that is not {@linkplain
   *     BehaviorStatus#heldSince held}
   */
  void resume(RequestedBy requester) {
    synchronized (status) { // a later pause must find the loop that it stops
      if (!isOver
          && (requester == RequestedBy.OPERATOR || status.status().heldSince() == null)
          && status.transition(EnumSet.of(Phase.PAUSED), Phase.RUNNING, "it goes on", false)) {
        loop.start();
      }
    }
  }

  /**
   * Stops the goal on request: suspends it and publishes the status. If a cycle is blocked, it
   * publishes the status at once.
   *
   * @param wanted {@link Phase#PAUSED} or {@link Phase#CANCELLED}
   * @param only the goal to stop; null for any
   * @param requester the goal is held if an operator stops it
   */
  void stop(Phase wanted, String why, @Nullable UUID only, RequestedBy requester) {
    Set<Phase> from =
        wanted == Phase.CANCELLED
            ? EnumSet.of(Phase.RUNNING, Phase.PAUSED)
            : EnumSet.of(Phase.RUNNING);
    boolean isIdle = !cycling.isHeldByCurrentThread() && await(cycling);
    try {
      synchronized (status) { // no other goal is started between the check and the stop
        BehaviorStatus now = status.status();
        if (!(only == null || only.equals(now.goal())) || stopAgain(now, wanted, why, requester)) {
          return;
        }
        if (!from.contains(now.phase())) {
          return;
        }
        loop.stop();
        if (!isIdle) {
          boolean unused = status.transition(from, wanted, why, requester == RequestedBy.OPERATOR);
        }
      }
      if (isIdle) {
        suspend();
        boolean unused = status.transition(from, wanted, why, requester == RequestedBy.OPERATOR);
      }
    } finally {
      if (isIdle) {
        cycling.unlock();
      }
    }
  }

  /**
   * Pauses a goal that is already paused, or stops a goal of the previous process: nothing moves,
   * and the goal no longer continues automatically.
   */
  private boolean stopAgain(BehaviorStatus now, Phase wanted, String why, RequestedBy requester) {
    if (now.phase() == Phase.IDLE && now.goal() != null && requester == RequestedBy.OPERATOR) {
      return status.transition(
          EnumSet.of(Phase.IDLE), Phase.CANCELLED, "it was stopped after its process ended", true);
    }
    return now.phase() == Phase.PAUSED
        && wanted == Phase.PAUSED
        && requester == RequestedBy.OPERATOR
        && status.transition(EnumSet.of(Phase.PAUSED), Phase.PAUSED, why, true);
  }

  /** Ends the executor; the goal is suspended, and its status stays. */
  @Override
  public void close() {
    isOver = true;
    loop.close(); // a cycle that waits for another module is interrupted
    if (await(cycling)) {
      try {
        suspend();
        execution = null;
      } finally {
        cycling.unlock();
      }
    } else {
      log.warn("{}: a cycle does not end; what it commands ends with its leases", path);
    }
  }

  /** Takes the lock, unless a cycle holds it for long. */
  private static boolean await(ReentrantLock lock) {
    boolean interrupted = false;
    try {
      while (true) {
        try {
          return lock.tryLock(CYCLE_TIMEOUT_MILLIS, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
          interrupted = true;
        }
      }
    } finally {
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  private void cycle() {
    cycling.lock();
    try {
      @Nullable GoalExecution now = execution;
      if (now == null || isOver || status.phase() != Phase.RUNNING) {
        return;
      }
      isSuspended = false;
      try {
        take(StepResult.ofNextStep(now));
      } catch (RuntimeException | Error e) { // for example, numbers out of range
        take(new StepResult.Faulty(e));
      }
      if (status.phase() != Phase.RUNNING && !isOver) { // stopped meanwhile, or ended
        suspend();
      }
    } finally {
      cycling.unlock();
    }
  }

  @GuardedBy("cycling")
  private void take(StepResult result) {
    if (result instanceof StepResult.Advanced advanced) {
      take(advanced.progress());
    } else if (result instanceof StepResult.Waiting waiting) {
      if (!isOver) { // the code that ends it suspends it
        suspend();
        status.updateProgress("it waits: " + waiting.inWords(), Completion.of(status.status()));
      }
    } else if (result instanceof StepResult.Stopped stopped) {
      end(stopped.phase(), stopped.why(), Completion.of(status.status()));
    } else if (result instanceof StepResult.Faulty faulty) {
      log.error("{}: a cycle failed", path, faulty.fault());
      faults.accept(faulty.fault());
      end(
          Phase.FAILED,
          "a fault of the behaviour: " + faulty.fault(),
          Completion.of(status.status()));
    }
  }

  @GuardedBy("cycling")
  private void take(GoalProgress progress) {
    Completion extent = Completion.of(progress).notBelow(status.status().completion());
    switch (progress.outcome()) {
      case REACHED -> end(Phase.SUCCEEDED, progress.activity(), extent.notBelow(1));
      case FAILED -> end(Phase.FAILED, progress.activity(), extent);
      case CANCELLED -> end(Phase.CANCELLED, progress.activity(), extent);
      case PAUSED -> end(Phase.PAUSED, progress.activity(), extent);
      default -> status.updateProgress(progress.activity(), extent);
    }
  }

  /** A cycle has ended or paused the goal. */
  @GuardedBy("cycling")
  private void end(Phase phase, String why, Completion extent) {
    loop.stop();
    suspend();
    status.end(phase, why, extent);
  }

  /** Called with the lock of cycles held. */
  @GuardedBy("cycling")
  private void suspend() {
    @Nullable GoalExecution now = execution;
    if (now == null || isSuspended) {
      return;
    }
    isSuspended = true;
    try {
      now.suspend();
    } catch (RuntimeException e) { // a fault; its commands end with its leases
      log.error("{}: it could not stop", path, e);
      faults.accept(e);
    }
  }
}
