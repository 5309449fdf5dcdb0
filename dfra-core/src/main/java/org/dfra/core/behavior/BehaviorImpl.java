package org.dfra.core.behavior;

import java.io.IOException;
import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.UUID;
import org.dfra.behavior.Behavior;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.Goal;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.behavior.Script;
import org.dfra.core.chain.DelayedTaskExecutor;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleDependency;
import org.dfra.core.module.SchemaImpl;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.persona.Attributes;
import org.dfra.persona.BehaviorAttributes;

/**
 * Base of every behaviour. It follows the transitions of {@link Phase}, and calls the {@link
 * GoalExecution} of its goal at a fixed rate. If a percept is missing or too old, a module is
 * unreachable, or another client commands an effector, the behaviour stops the robot and reports
 * what it waits for. If an effector is in an emergency stop, the goal is cancelled, since the
 * release must not move the robot. If a parking brake is set, the goal is paused for the same
 * reason.
 *
 * <p>A module that does not answer may block a cycle. Callers do not wait long for it: a pause or
 * cancel takes effect at once, and the cycle stops the robot at its end. A new goal is refused
 * while the behaviour is {@linkplain GoalRefusedException#isBusy busy} with the cycle.
 *
 * <p>Parameters {@code rate}: cycles per second, 1 to 50 Hz; {@code drive}: name of the drive that
 * its goals move, by default any of its robot. Read-only: {@code lateness_p99}, the 99th percentile
 * of the lateness of the last 600 cycles, seconds; {@code missed_cycles}, the number of missed
 * cycles.
 *
 * @param <G> its type of goals
 */
public abstract class BehaviorImpl<G extends Goal> extends SchemaImpl implements Behavior<G> {

  private final String goalType;
  private final double rate;
  private final DelayedTaskExecutor taskExecutor;
  private final DriveInterlock interlock;
  private final BehaviorStatusTracker status;

  /** Used under the lock of {@link #status}, except for the requester. */
  private final LastGoalStore memory;

  private final GoalExecutor executor;

  /**
   * See {@link org.dfra.core.module.ModuleImpl}.
   *
   * @param goal its type of goals
   * @param defaultRate cycles per second unless configured, hertz
   */
  protected BehaviorImpl(
      ModuleContext context,
      String description,
      String author,
      String version,
      Class<G> goal,
      double defaultRate) {
    super(context, description, author, version, List.of("BehaviorStatus"));
    this.goalType = goal.getSimpleName();
    this.rate = settings().number("rate", defaultRate, 1, 50);
    this.taskExecutor =
        new DelayedTaskExecutor("dfra-errands " + context.path(), context.robotTime());
    this.interlock =
        new DriveInterlock(
            context, ModuleDependency.of(context, DriveEffector.class, "drive"), log);
    this.memory = new LastGoalStore(context.state());
    this.status = new BehaviorStatusTracker(clock(), this::storeAndPublish, this::changed);
    this.executor =
        new GoalExecutor(path(), context.robotTime(), rate, status, log, this::recordException);
    parameterTable()
        .declareReadOnly(
            "lateness_p99",
            "seconds that 99 % of the last 600 turns were late at the most",
            () -> String.format(Locale.ROOT, "%.4f", executor.lateness(0.99)));
    parameterTable()
        .declareReadOnly(
            "missed_cycles",
            "cycles that were skipped, since others took too long",
            () -> Long.toString(executor.missedCycles()));
  }

  /**
   * Starts a goal.
   *
   * @throws GoalRefusedException if it cannot be reached; nothing has moved
   * @throws NotReadyException if a required module is not available; nothing has moved
   */
  protected abstract GoalExecution startGoal(G goal) throws RemoteException;

  /**
   * Called before a goal is executed for the first time, or resumed on request; on the caller's
   * thread. Not called if a goal continues automatically. If the behaviour {@linkplain #movesWheels
   * moves the wheels}, it releases their parking brake.
   *
   * @param requester decides whether a parking brake may be released
   * @throws NotReadyException if it cannot be executed now; a new goal is then refused, but a
   *     paused one resumes
   */
  protected void prepare(RequestedBy requester) throws RemoteException {
    if (movesWheels()) {
      interlock.prepare(requester);
    }
  }

  /**
   * Whether its goals move the robot's wheels, also through other behaviours. Then the parking
   * brake is released when an operator requests a goal, and {@link #interlock} detects whether the
   * wheels were stopped since. A behaviour that moves only a camera must not release the brake.
   */
  protected boolean movesWheels() {
    return false;
  }

  /**
   * The interlock that binds the goal to the state of the robot's wheels at the time of the
   * request.
   *
   * @throws IllegalStateException if the behaviour does not declare that it {@linkplain
   *     #movesWheels moves the wheels}
   */
  protected final DriveInterlock interlock() {
    if (!movesWheels()) {
      throw new IllegalStateException(
          path() + " uses the interlock of the wheels; have movesWheels return true");
    }
    return interlock;
  }

  /** Its attributes besides those of every behaviour; cached values. */
  protected List<? extends Attributes> behaviorAttributes() {
    return List.of();
  }

  @Override
  protected final List<? extends Attributes> additionalAttributes() {
    List<Attributes> all = new ArrayList<>();
    BehaviorStatus now = status.status();
    all.add(
        new BehaviorAttributes(
            goalType, this instanceof Script, now.phase().name(), rate, now.heldSince()));
    all.addAll(behaviorAttributes());
    return all;
  }

  /** Runs tasks outside the control cycles; it ends with the module. */
  protected final DelayedTaskExecutor taskExecutor() {
    return taskExecutor;
  }

  @Override
  protected void onStart() {
    super.onStart();
    try {
      memory.load(clock()).ifPresent(status::restore);
      memory.loadRequester();
    } catch (IOException e) {
      log.warn("{}: it does not know what became of its last goal: {}", path(), e.toString());
      recordException(e);
    }
    transitionTo(Readiness.READY);
  }

  /** Stored before it is published: by then the robot has stopped, or has not begun to move. */
  private void storeAndPublish(BehaviorStatus fresh) {
    try {
      memory.save(fresh);
    } catch (IOException e) {
      log.warn("{}: the next process would not know of this goal: {}", path(), e.toString());
      recordException(e);
    }
    publish(fresh);
  }

  @Override
  protected void onClose() {
    executor.close();
    taskExecutor.close();
    super.onClose();
  }

  @Override
  public final UUID pursue(G goal) throws RemoteException {
    return pursue(goal, RequestedBy.OPERATOR);
  }

  @Override
  public final UUID pursueUnattended(G goal) throws RemoteException {
    return pursue(goal, RequestedBy.PROGRAM);
  }

  private UUID pursue(G goal, RequestedBy requester) throws RemoteException {
    return executor.accept(
        this::requireReady,
        () -> {
          GoalExecution begun = startGoal(goal);
          prepare(requester);
          return begun;
        });
  }

  private void requireReady() {
    if (executor.isClosed() || !readiness().serves()) {
      throw new NotReadyException(path(), readiness(), "it cannot take up a goal now");
    }
  }

  /**
   * Restores a goal that an earlier process started.
   *
   * @param phase {@link Phase#RUNNING}, or {@link Phase#PAUSED} if it shall wait to be resumed
   * @param before the goal's earlier progress; only its numbers are used
   */
  protected final void restoreGoal(GoalExecution begun, Phase phase, GoalProgress before) {
    executor.restore(begun, phase, BehaviorStatusTracker.Completion.of(before));
  }

  /**
   * {@inheritDoc}
   *
   * @throws NotReadyException if it has ended during a goal, which is no longer pursued
   */
  @Override
  public final BehaviorStatus status() {
    BehaviorStatus now = status.status();
    if (executor.isClosed() && now.phase().isUnderWay()) {
      throw new NotReadyException(path(), readiness(), "it has ended before its goal was reached");
    }
    return now;
  }

  @Override
  public final void pause() {
    executor.stop(Phase.PAUSED, "a client paused it", null, RequestedBy.OPERATOR);
  }

  /**
   * Pauses the goal as an operator would, since the one who gave it may no longer.
   *
   * @param why in words, for the status
   */
  public final void pauseBecause(String why) {
    executor.stop(Phase.PAUSED, why, null, RequestedBy.OPERATOR);
  }

  /**
   * Who has given or resumed the last goal, also to an earlier process: what the module's server
   * has {@linkplain #storeRequester stored}; empty if nothing.
   */
  public final String requester() {
    return memory.requester();
  }

  /**
   * Stores who gives or resumes a goal, before it is executed. Without its file the next process
   * does not know; then it is logged.
   *
   * @param requester as the module's server writes it; empty for nobody who has to be known
   */
  public final void storeRequester(String requester) {
    try {
      memory.storeRequester(requester);
    } catch (IOException e) {
      log.warn("{}: the next process would not know who gave this goal: {}", path(), e.toString());
      recordException(e);
    }
  }

  @Override
  public final void pauseUnattended() {
    executor.stop(Phase.PAUSED, "a program paused it", null, RequestedBy.PROGRAM);
  }

  @Override
  public final void cancel() {
    executor.stop(Phase.CANCELLED, "a client cancelled it", null, RequestedBy.OPERATOR);
  }

  @Override
  public final void cancel(UUID goal) {
    executor.stop(Phase.CANCELLED, "a client cancelled it", goal, RequestedBy.OPERATOR);
  }

  @Override
  public final void cancelUnattended(UUID goal) {
    executor.stop(Phase.CANCELLED, "a program cancelled it", goal, RequestedBy.PROGRAM);
  }

  @Override
  public final void resume() {
    if (!executor.isClosed() && status.phase() == Phase.PAUSED) {
      try {
        prepare(RequestedBy.OPERATOR);
      } catch (RemoteException | NotReadyException e) { // the next cycle reports the cause
        log.info("{}: it goes on without preparation: {}", path(), e.toString());
      }
    }
    executor.resume(RequestedBy.OPERATOR);
  }

  @Override
  public final void resumeUnattended() {
    executor.resume(RequestedBy.PROGRAM);
  }

  /** Called when the phase changes. Never called by two threads at once; must not block. */
  protected void onPhase(Phase phase) {}

  private void changed(Phase from, BehaviorStatus fresh) {
    log.info("{}: {} -> {}: {}", path(), from, fresh.phase(), fresh.activity());
    onPhase(fresh.phase());
  }

  /** Who requests that a behaviour starts, goes on or stops. */
  public enum RequestedBy {
    /**
     * An operator who knows that the robot may move: a parking brake may be released, and a goal
     * that is stopped is {@linkplain org.dfra.behavior.BehaviorStatus#heldSince held}.
     */
    OPERATOR,
    /** A program: no brake is released, and a goal that is stopped is not held. */
    PROGRAM
  }
}
