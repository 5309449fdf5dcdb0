package org.dfra.core.behavior;

import java.io.IOException;
import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;
import org.dfra.behavior.Behavior;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.Goal;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.behavior.Script;
import org.dfra.core.chain.ControlLoop;
import org.dfra.core.chain.Errands;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.Needed;
import org.dfra.core.module.SchemaImpl;
import org.dfra.flow.effector.BrakeEngagedException;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.effector.StoppedForEmergency;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.module.NotReadyException;
import org.dfra.module.Readiness;
import org.dfra.persona.Attributes;
import org.dfra.persona.BehaviorAttributes;
import org.jspecify.annotations.Nullable;

/**
 * Base of every behaviour. It moves along the arrows of {@link Phase}, and gives the {@link
 * Pursuit} of its goal a turn at a rate. Where a percept is missing or too old, a module is out of
 * reach, or another commands an effector, the behaviour comes to rest and says what it waits for.
 * Where an effector is stopped for an emergency, the goal is cancelled, since the release is not to
 * move the robot. Where a parking brake is set, the goal is paused for the same reason.
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
  private final ControlLoop loop;
  private final Errands errands;
  private final DriveInterlock interlock;

  /** How long a turn that is under way is waited for: less than a call's deadline. */
  private static final long PATIENCE_MILLIS = 1000;

  /** Held during every turn and while a goal is taken up; others are called under it. */
  private final ReentrantLock turning = new ReentrantLock();

  private @Nullable Pursuit pursuit; // guarded by turning; the last that was begun
  private boolean isAtRest; // guarded by turning

  /** Its lock is taken after {@link #turning}. */
  private final StatusLine said;

  /** Used under the lock of {@link #said}. */
  private final GoalMemory memory;

  private volatile boolean isOver;

  /**
   * See {@link org.dfra.core.module.ModuleImpl}.
   *
   * @param goal what it can reach
   * @param usualRate turns per second where nothing else is written, hertz
   */
  protected BehaviorImpl(
      ModuleContext context,
      String description,
      String author,
      String version,
      Class<G> goal,
      double usualRate) {
    super(context, description, author, version, List.of("BehaviorStatus"));
    this.goalType = goal.getSimpleName();
    this.rate = settings().number("rate", usualRate, 1, 50);
    this.loop =
        new ControlLoop("dfra-behavior " + context.path(), context.robotTime(), rate, this::turn);
    this.errands = new Errands("dfra-errands " + context.path(), context.robotTime());
    this.interlock =
        new DriveInterlock(context, Needed.of(context, DriveEffector.class, "drive"), log);
    this.memory = new GoalMemory(context.state());
    this.said = new StatusLine(clock(), this::say, this::changed);
    declared()
        .show(
            "lateness_p99",
            "seconds that 99 % of the last 600 turns were late at the most",
            () -> String.format(Locale.ROOT, "%.4f", loop.lateness(0.99)));
    declared()
        .show(
            "turns_missed",
            "turns that were left out, since others took too long",
            () -> Long.toString(loop.missed()));
  }

  /**
   * Takes up a goal.
   *
   * @throws GoalRefusedException if it cannot be reached; nothing has moved
   * @throws NotReadyException if a module that is needed is not there; nothing has moved
   */
  protected abstract Pursuit begin(G goal) throws RemoteException;

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
  protected List<? extends Attributes> behaviorTraits() {
    return List.of();
  }

  @Override
  protected final List<? extends Attributes> furtherAttributes() {
    List<Attributes> all = new ArrayList<>();
    BehaviorStatus now = said.now();
    all.add(
        new BehaviorAttributes(
            goalType, this instanceof Script, now.phase().name(), rate, now.heldSince()));
    all.addAll(behaviorTraits());
    return all;
  }

  /** For what is to be done beside the turns; they end with the module. */
  protected final Errands errands() {
    return errands;
  }

  @Override
  protected void onStart() {
    super.onStart();
    try {
      memory.recall(clock()).ifPresent(said::restore);
    } catch (IOException e) {
      log.warn("{}: it does not know what became of its last goal: {}", path(), e.toString());
      survived(e);
    }
    become(Readiness.READY);
  }

  /** Written down before it is told: the robot stands by then, or has not begun to move yet. */
  private void say(BehaviorStatus fresh) {
    try {
      memory.keep(fresh);
    } catch (IOException e) {
      log.warn("{}: the next process would not know of this goal: {}", path(), e.toString());
      survived(e);
    }
    tell(fresh);
  }

  @Override
  protected void onClose() {
    isOver = true;
    loop.close(); // a turn that waits for another module is interrupted
    if (await(turning)) {
      try {
        rest();
        pursuit = null;
      } finally {
        turning.unlock();
      }
    } else {
      log.warn("{}: a turn does not end; what it commands ends with its leases", path());
    }
    errands.close();
    super.onClose();
  }

  /** Takes the lock, unless a turn holds it for long. */
  private static boolean await(ReentrantLock lock) {
    boolean interrupted = false;
    try {
      while (true) {
        try {
          return lock.tryLock(PATIENCE_MILLIS, TimeUnit.MILLISECONDS);
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

  @Override
  public final UUID pursue(G goal) throws RemoteException {
    return pursue(goal, true);
  }

  @Override
  public final UUID pursueUnattended(G goal) throws RemoteException {
    return pursue(goal, false);
  }

  private UUID pursue(G goal, boolean isAttended) throws RemoteException {
    if (!await(turning)) {
      throw GoalRefusedException.busy(
          path() + " waits for a module that does not answer; ask again in a few seconds");
    }
    try {
      if (isOver || !readiness().serves()) {
        throw new NotReadyException(path(), readiness(), "it cannot take up a goal now");
      }
      if (said.phase().isUnderWay()) {
        throw GoalRefusedException.busy(
            path()
                + " is at another goal ("
                + said.now().doing()
                + "); cancel that first, or wait for its end");
      }
      Pursuit begun = begin(goal);
      prepare(isAttended);
      return takeUp(begun, Phase.RUNNING, "it begins", 0, 0);
    } finally {
      turning.unlock();
    }
  }

  /**
   * Goes on with what was begun in an earlier life.
   *
   * @param phase {@link Phase#RUNNING}, or {@link Phase#PAUSED} where it is to wait to be resumed
   * @param done share of the goal that was dealt with
   * @param missed parts of that which were left out
   */
  protected final void goOn(Pursuit begun, Phase phase, double done, int missed) {
    turning.lock();
    try {
      UUID unused = takeUp(begun, phase, "it was begun before this process", done, missed);
    } finally {
      turning.unlock();
    }
  }

  private UUID takeUp(Pursuit taken, Phase phase, String doing, double done, int missed) {
    UUID id = UUID.randomUUID();
    said.begin(id, phase, doing, done, missed);
    pursuit = taken;
    isAtRest = true;
    if (phase == Phase.RUNNING) {
      loop.start();
    }
    return id;
  }

  /**
   * {@inheritDoc}
   *
   * @throws NotReadyException if it has ended with a goal under way, which nobody pursues any more
   */
  @Override
  public final BehaviorStatus status() {
    BehaviorStatus now = said.now();
    if (isOver && now.phase().isUnderWay()) {
      throw new NotReadyException(path(), readiness(), "it has ended before its goal was reached");
    }
    return now;
  }

  @Override
  public final void pause() {
    stop(Phase.PAUSED, "it was told to pause", null, true);
  }

  @Override
  public final void pauseUnattended() {
    stop(Phase.PAUSED, "it was told to pause by a program", null, false);
  }

  @Override
  public final void cancel() {
    stop(Phase.CANCELLED, "it was told to give up", null, true);
  }

  @Override
  public final void cancel(UUID goal) {
    stop(Phase.CANCELLED, "it was told to give up", goal, true);
  }

  @Override
  public final void cancelUnattended(UUID goal) {
    stop(Phase.CANCELLED, "it was told to give up by a program", goal, false);
  }

  @Override
  public final void resume() {
    if (!isOver && said.phase() == Phase.PAUSED) {
      try {
        prepare(true);
      } catch (RemoteException | NotReadyException e) { // the next cycle finds what is in the way
        log.info("{}: it goes on without preparation: {}", path(), e.toString());
      }
    }
    resume(true);
  }

  @Override
  public final void resumeUnattended() {
    resume(false);
  }

  private void resume(boolean isAttended) {
    synchronized (said) { // who pauses it again is to find the loop that he stops
      if (!isOver
          && (isAttended || said.now().heldSince() == null)
          && said.move(EnumSet.of(Phase.PAUSED), Phase.RUNNING, "it goes on", false)) {
        loop.start();
      }
    }
  }

  /**
   * Somebody wants it to stop: rests and says so; says so at once where a turn is held up.
   *
   * @param only the goal that is meant; null for whichever is being pursued
   * @param isAttended false where a program stops it, so that it is not held
   */
  private void stop(Phase wanted, String why, @Nullable UUID only, boolean isAttended) {
    Set<Phase> from =
        wanted == Phase.CANCELLED
            ? EnumSet.of(Phase.RUNNING, Phase.PAUSED)
            : EnumSet.of(Phase.RUNNING);
    boolean isIdle = !turning.isHeldByCurrentThread() && await(turning);
    try {
      synchronized (said) { // no other goal is taken up between the question and the stop
        BehaviorStatus now = said.now();
        if (!(only == null || only.equals(now.goal())) || stopAgain(now, wanted, isAttended)) {
          return;
        }
        if (!from.contains(now.phase())) {
          return;
        }
        loop.stop();
        if (!isIdle) {
          boolean unused = said.move(from, wanted, why, isAttended);
        }
      }
      if (isIdle) {
        rest();
        boolean unused = said.move(from, wanted, why, isAttended);
      }
    } finally {
      if (isIdle) {
        turning.unlock();
      }
    }
  }

  /**
   * Somebody pauses what pauses already, or stops a goal that the process before this one pursued:
   * nothing moves, and nothing is to go on by itself from now on.
   */
  private boolean stopAgain(BehaviorStatus now, Phase wanted, boolean isAttended) {
    if (now.phase() == Phase.IDLE && now.goal() != null && isAttended) {
      return said.move(
          EnumSet.of(Phase.IDLE), Phase.CANCELLED, "it was stopped after its process ended", true);
    }
    return now.phase() == Phase.PAUSED
        && wanted == Phase.PAUSED
        && isAttended
        && said.move(EnumSet.of(Phase.PAUSED), Phase.PAUSED, "it was told to pause", true);
  }

  /** Holds the lock of turns. */
  private void rest() {
    @Nullable Pursuit now = pursuit;
    if (now == null || isAtRest) {
      return;
    }
    isAtRest = true;
    try {
      now.rest();
    } catch (RuntimeException e) { // a fault; what it commands ends with its leases
      log.error("{}: it could not come to rest", path(), e);
      survived(e);
    }
  }

  /** It is at this now. Never called by two threads at once; must not block. */
  protected void onPhase(Phase phase) {}

  private void turn() {
    turning.lock();
    try {
      @Nullable Pursuit now = pursuit;
      if (now == null || isOver || said.phase() != Phase.RUNNING) {
        return;
      }
      isAtRest = false;
      step(now);
      if (said.phase() != Phase.RUNNING && !isOver) { // stopped meanwhile, or ended
        rest();
      }
    } finally {
      turning.unlock();
    }
  }

  private void step(Pursuit now) {
    try {
      take(now.step());
    } catch (NotReadyException
        | CommandRefusedException
        | LeaseRefusedException
        | RemoteException e) {
      if (e instanceof StoppedForEmergency) { // its release must not move the robot
        end(Phase.CANCELLED, String.valueOf(e.getMessage()));
      } else if (e instanceof BrakeEngagedException) { // likewise
        end(Phase.PAUSED, e.getMessage() + "; when it may move, resume the goal");
      } else {
        await(e);
      }
    } catch (DelegateHeldException e) {
      end(Phase.PAUSED, e.getMessage() + "; when it may move, resume the goal");
    } catch (GoalRefusedException e) {
      if (e.isBusy()) {
        await(e);
      } else {
        fail(e);
      }
    } catch (RuntimeException | Error e) {
      fail(e);
    }
  }

  private void await(Exception reason) {
    if (!isOver) { // whoever ends it has it rest
      rest();
      BehaviorStatus last = said.now();
      said.goOn("it waits: " + inWords(reason), last.done(), last.missed());
    }
  }

  /** One line: a call that failed tells of its causes on lines of their own. */
  private static String inWords(Exception reason) {
    String message = String.valueOf(reason.getMessage());
    boolean isCall = reason instanceof RemoteException && reason.getCause() != null;
    int nested = message.indexOf("; nested exception is:");
    return isCall && nested > 0 ? "a call failed: " + message.substring(0, nested) : message;
  }

  /** A fault of the behaviour; the robot must not drive on. */
  private void fail(Throwable e) {
    log.error("{}: a turn failed", path(), e);
    survived(e);
    end(Phase.FAILED, "a fault of the behaviour: " + e);
  }

  private void take(Progress progress) {
    double done = Math.max(said.now().done(), progress.done());
    int missed = progress.missed();
    switch (progress.outcome()) {
      case REACHED -> end(Phase.SUCCEEDED, progress.doing(), 1, missed);
      case FAILED -> end(Phase.FAILED, progress.doing(), done, missed);
      case CANCELLED -> end(Phase.CANCELLED, progress.doing(), done, missed);
      case HELD -> end(Phase.PAUSED, progress.doing(), done, missed);
      default -> said.goOn(progress.doing(), done, missed);
    }
  }

  /** It ends as far as it is. */
  private void end(Phase phase, String why) {
    BehaviorStatus last = said.now();
    end(phase, why, last.done(), last.missed());
  }

  /** A turn has come to an end of the pursuit, or to a pause. */
  private void end(Phase phase, String why, double done, int missed) {
    loop.stop();
    rest();
    said.end(phase, why, done, missed);
  }

  private void changed(Phase from, BehaviorStatus fresh) {
    log.info("{}: {} -> {}: {}", path(), from, fresh.phase(), fresh.doing());
    onPhase(fresh.phase());
  }
}
