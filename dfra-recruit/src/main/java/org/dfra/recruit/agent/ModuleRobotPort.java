package org.dfra.recruit.agent;

import java.time.Duration;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.dfra.agent.HelpCall;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.LegGoal;
import org.dfra.core.chain.DelayedTaskExecutor;
import org.dfra.core.module.ModuleContext;
import org.dfra.directory.ModuleListing;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.geometry.GeoPosition;
import org.slf4j.Logger;

/**
 * Implements the port with the robot's own modules: {@link RobotStateMonitor} gives position and
 * charge, a {@link WaypointTrip} drives to the place, and {@link InterruptedSearches} are paused
 * and resumed. Calls to its modules run on their own thread, {@code dfra-robot-port robot/name}.
 */
final class ModuleRobotPort implements RobotPort, AutoCloseable {

  /** Timeout of the stop command on shutdown. */
  private static final long PATIENCE_MILLIS = 2000;

  private final RobotTraits traits;
  private final RobotStateMonitor robotState;
  private final DelayedTaskExecutor taskExecutor;
  private final OperatorHold hold;
  private final WaypointTrip trip; // task thread only, except for its last goal
  private final InterruptedSearches work; // by errands only
  private volatile boolean isAway; // helping, or on its way; written by the task thread only
  private volatile boolean isStarted; // whether its modules can be found
  private volatile boolean isEnding; // the end of its last trip may be unknown yet
  private volatile Runnable onHold = () -> {};
  private Optional<String> reportedHold = Optional.empty(); // by errands only
  private final AtomicBoolean isClosed = new AtomicBoolean();
  private boolean isRetrying; // task thread only; to resume its work

  ModuleRobotPort(ModuleContext context, RobotTraits traits, Logger log) {
    this.traits = traits;
    this.robotState = new RobotStateMonitor(context, this::begunByOthers, log);
    this.taskExecutor =
        new DelayedTaskExecutor("dfra-robot-port " + context.path(), context.robotTime());
    this.work = new InterruptedSearches(context, log);
    this.hold = new OperatorHold(context, robotState, log);
    this.trip = new WaypointTrip(context, taskExecutor, work, hold, log);
  }

  /** Ends the trip of an earlier process; the searches it interrupted stay as they are. */
  void stop() {
    taskExecutor.execute(trip::end);
  }

  /** Registers a callback, run on the task thread, for each start and end of a hold. */
  void onHoldChange(Runnable listener) {
    onHold = listener;
  }

  void start() {
    work.load();
    trip.recall();
    hold.recall(work.hasLeft() || !trip.isSettled());
    isStarted = true;
    isEnding = !trip.isSettled();
    taskExecutor.execute(this::watchHold);
    robotState.start();
  }

  private void watchHold() {
    if (isClosed.get()) {
      return;
    }
    hold.refresh();
    hold.settle();
    Optional<String> why = hold.reason();
    if (!why.equals(reportedHold)) {
      reportedHold = why;
      onHold.run();
    }
    taskExecutor.schedule(WaypointTrip.POLL_INTERVAL_NANOS, this::watchHold);
  }

  /** The agent starts nothing while it is held, so an operator started this. */
  private void begunByOthers(ModuleListing<?> behavior, BehaviorStatus status) {
    if (!isAway && !Objects.equals(status.goal(), trip.lastGoal())) {
      hold.endedByGoal(behavior.path(), status.measured());
    }
  }

  @Override
  public Optional<String> holdReason() {
    return isStarted ? hold.reason() : Optional.empty();
  }

  /**
   * {@inheritDoc} This moves nothing: neither a leg nor a search that waits until it is known
   * whether the robot was stopped.
   */
  @Override
  public void endHold() {
    hold.end();
    taskExecutor.execute(this::giveUpWhatWaits); // nothing starts before that
  }

  private void giveUpWhatWaits() {
    if (!hold.isSettled()) {
      work.handOverToOperator();
      hold.settleByPerson();
      trip.giveUp(
          "an operator ended the hold, which starts no motion; the robot waits for the next call");
    }
  }

  /**
   * {@inheritDoc} The robot is then stopped. If its modules delay that for too long, the next
   * process of the agent stops it, or continues.
   */
  @Override
  public void close() {
    if (isClosed.getAndSet(true)) {
      return;
    }
    robotState.close();
    trip.close();
    CountDownLatch stands = new CountDownLatch(1);
    taskExecutor.execute(
        () -> {
          trip.end();
          stands.countDown();
        });
    try {
      boolean unused = stands.await(PATIENCE_MILLIS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    taskExecutor.close();
  }

  @Override
  public boolean canObserve(String percept) {
    return traits.percepts().contains(percept);
  }

  /**
   * A robot is available if it knows its position, has charge left, is not held after a stop, and
   * no other client drives it. The drive goals of its help and of its searches are its own. As long
   * as the end of its last trip is unknown, or a new process has not queried all of its behaviours,
   * it may have been stopped.
   */
  @Override
  public boolean isAvailable() {
    return robotState.pose() != null
        && battery() > traits.batteryReserve()
        && !isEnding
        && hold.isSettled()
        && hold.reason().isEmpty()
        && (isAway || robotState.isSearching() || !robotState.isDriving());
  }

  @Override
  public boolean hasOwnWork() {
    return robotState.isSearching();
  }

  @Override
  public boolean isInField(GeoPosition place) {
    return traits.isInField(place);
  }

  /** {@inheritDoc} From the robot's description alone; its drive is not queried. */
  @Override
  public Optional<Duration> eta(GeoPosition place) {
    PoseEstimate here = robotState.pose();
    if (here == null) {
      return Optional.empty();
    }
    double seconds = here.position().groundDistance(place) * traits.detourFactor() / traits.speed();
    return Optional.of(Duration.ofNanos((long) (seconds * 1e9)));
  }

  @Override
  public double battery() {
    return robotState.battery();
  }

  @Override
  public void travelTo(HelpCall call, long leaseEnd, TravelListener listener) {
    taskExecutor.execute(
        () -> {
          isAway = true;
          isEnding = false;
          work.pauseSearches();
          trip.begin(new LegGoal(null, call.position(), traits.tolerance()), leaseEnd, listener);
        });
  }

  @Override
  public void extendLease(long leaseEnd) {
    taskExecutor.execute(() -> trip.extendLease(leaseEnd));
  }

  /** It stays at its position: its sensors observe from there. */
  @Override
  public void observe(HelpCall call) {
    taskExecutor.execute(
        () -> {
          isAway = true;
          isEnding = false;
          trip.end();
        });
  }

  @Override
  public void resumeOwnWork() {
    isEnding = true;
    taskExecutor.execute(
        () -> {
          isAway = false;
          trip.end();
          goOn();
        });
  }

  /**
   * Retries if a search does not respond, until the next trip. Nothing is resumed as long as it is
   * unknown whether the robot, or the trip of an earlier process, was stopped.
   */
  private void goOn() {
    boolean isDone = isAway || (trip.isSettled() && isKnownWhetherHeld() && goOnUnlessHeld());
    if (!isDone && !isRetrying) {
      isRetrying = true;
      taskExecutor.schedule(
          2 * WaypointTrip.POLL_INTERVAL_NANOS,
          () -> {
            isRetrying = false;
            goOn();
          });
    }
  }

  /** One known hold is sufficient; the absence of a hold is known when all were queried. */
  private boolean isKnownWhetherHeld() {
    hold.settle();
    return hold.isSettled() || hold.stopReason().isPresent();
  }

  private boolean goOnUnlessHeld() {
    isEnding = false;
    if (hold.reason().isPresent()) {
      work.handOverToOperator();
    }
    return work.resumeSearches();
  }
}
