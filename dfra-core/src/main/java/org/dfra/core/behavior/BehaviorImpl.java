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
import org.dfra.module.NotReadyException;
import org.dfra.module.Readiness;
import org.dfra.persona.Attributes;
import org.dfra.persona.BehaviorAttributes;

/**
 * Base of every behaviour. It moves along the arrows of {@link Phase}, and gives the {@link
 * GoalExecution} of its goal a turn at a rate. Where a percept is missing or too old, a module is
 * out of reach, or another commands an effector, the behaviour comes to rest and says what it waits
 * for. Where an effector is stopped for an emergency, the goal is cancelled, since the release is
 * not to move the robot. Where a parking brake is set, the goal is paused for the same reason.
 *
 * <p>A turn may be held up by a module that does not answer. Nobody waits for it for long: who
 * pauses or cancels is obeyed at once, and the turn comes to rest at its end; a goal is refused as
 * long as the behaviour is {@linkplain GoalRefusedException#isBusy busy} with it.
 *
 * <p>Parameters {@code rate}: turns per second, 1 to 50 Hz; {@code drive}: name of the wheels that
 * its goals move, any of its robot where it is not set. To be read only: {@code lateness_p99},
 * seconds that 99 % of the last 600 turns were late at the most; {@code turns_missed}.
 *
 * @param <G> what it can reach
 */
public abstract class BehaviorImpl<G extends Goal> extends SchemaImpl implements Behavior<G> {

  private final String goalType;
  private final double rate;
  private final DelayedTaskExecutor taskExecutor;
  private final DriveInterlock interlock;
  private final BehaviorStatusTracker status;

  /** Used under the lock of {@link #status}. */
  private final LastGoalStore memory;

  private final GoalExecutor executor;

  /**
   * See {@link org.dfra.core.module.ModuleImpl}.
   *
   * @param goal what it can reach
   * @param defaultRate turns per second where nothing else is written, hertz
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
            "turns_missed",
            "turns that were left out, since others took too long",
            () -> Long.toString(executor.missedCycles()));
  }

  /**
   * Takes up a goal.
   *
   * @throws GoalRefusedException if it cannot be reached; nothing has moved
   * @throws NotReadyException if a module that is needed is not there; nothing has moved
   */
  protected abstract GoalExecution startGoal(G goal) throws RemoteException;

  /**
   * A goal that has begun is about to be pursued for the first time, or a paused one again because
   * somebody asks for it; on that caller's thread. Not called where a goal goes on by itself. Where
   * the behaviour {@linkplain #movesWheels moves the wheels}, it releases their parking brake.
   *
   * @param isAttended whether somebody who knows that the robot may move has asked for it, so that
   *     a parking brake may be released
   * @throws NotReadyException if it cannot be pursued now; a goal is not taken up then, and a
   *     paused one goes on nevertheless
   */
  protected void prepare(boolean isAttended) throws RemoteException {
    if (movesWheels()) {
      interlock.prepare(isAttended);
    }
  }

  /**
   * Whether its goals move the robot's wheels, also by way of other behaviours. Then the parking
   * brake is released when a person asks for a goal, and {@link #interlock} tells whether the
   * wheels were stopped since. One that moves nothing but a camera must not release the brake.
   */
  protected boolean movesWheels() {
    return false;
  }

  /**
   * Ties the goal to what was true of its robot's wheels when somebody asked for it.
   *
   * @throws IllegalStateException if the behaviour does not say that it {@linkplain #movesWheels
   *     moves the wheels}: then nothing is tied
   */
  protected final DriveInterlock interlock() {
    if (!movesWheels()) {
      throw new IllegalStateException(
          path() + " uses the interlock of the wheels; have movesWheels return true");
    }
    return interlock;
  }

  /** What it says of itself besides what every behaviour does; from memory. */
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

  /** For what is to be done beside the turns; they end with the module. */
  protected final DelayedTaskExecutor taskExecutor() {
    return taskExecutor;
  }

  @Override
  protected void onStart() {
    super.onStart();
    try {
      memory.load(clock()).ifPresent(status::restore);
    } catch (IOException e) {
      log.warn("{}: it does not know what became of its last goal: {}", path(), e.toString());
      recordException(e);
    }
    transitionTo(Readiness.READY);
  }

  /** Written down before it is told: the robot stands by then, or has not begun to move yet. */
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
    return pursue(goal, true);
  }

  @Override
  public final UUID pursueUnattended(G goal) throws RemoteException {
    return pursue(goal, false);
  }

  private UUID pursue(G goal, boolean isAttended) throws RemoteException {
    return executor.accept(
        this::requireReady,
        () -> {
          GoalExecution begun = startGoal(goal);
          prepare(isAttended);
          return begun;
        });
  }

  private void requireReady() {
    if (executor.isClosed() || !readiness().serves()) {
      throw new NotReadyException(path(), readiness(), "it cannot take up a goal now");
    }
  }

  /**
   * Goes on with what was begun in an earlier life.
   *
   * @param phase {@link Phase#RUNNING}, or {@link Phase#PAUSED} where it is to wait to be resumed
   * @param before how far the goal was; only its numbers count
   */
  protected final void restoreGoal(GoalExecution begun, Phase phase, GoalProgress before) {
    executor.restore(begun, phase, BehaviorStatusTracker.Completion.of(before));
  }

  /**
   * {@inheritDoc}
   *
   * @throws NotReadyException if it has ended with a goal under way, which nobody pursues any more
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
    executor.stop(Phase.PAUSED, "it was told to pause", null, true);
  }

  @Override
  public final void pauseUnattended() {
    executor.stop(Phase.PAUSED, "it was told to pause by a program", null, false);
  }

  @Override
  public final void cancel() {
    executor.stop(Phase.CANCELLED, "it was told to give up", null, true);
  }

  @Override
  public final void cancel(UUID goal) {
    executor.stop(Phase.CANCELLED, "it was told to give up", goal, true);
  }

  @Override
  public final void cancelUnattended(UUID goal) {
    executor.stop(Phase.CANCELLED, "it was told to give up by a program", goal, false);
  }

  @Override
  public final void resume() {
    if (!executor.isClosed() && status.phase() == Phase.PAUSED) {
      try {
        prepare(true);
      } catch (RemoteException | NotReadyException e) { // the next cycle finds what is in the way
        log.info("{}: it goes on without preparation: {}", path(), e.toString());
      }
    }
    executor.resume(true);
  }

  @Override
  public final void resumeUnattended() {
    executor.resume(false);
  }

  /** It is at this now. Never called by two threads at once; must not block. */
  protected void onPhase(Phase phase) {}

  private void changed(Phase from, BehaviorStatus fresh) {
    log.info("{}: {} -> {}: {}", path(), from, fresh.phase(), fresh.activity());
    onPhase(fresh.phase());
  }
}
