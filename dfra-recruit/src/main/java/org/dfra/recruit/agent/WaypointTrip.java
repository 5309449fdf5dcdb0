package org.dfra.recruit.agent;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.GoToWaypoint;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.behavior.LegGoal;
import org.dfra.core.behavior.DelegateHeldException;
import org.dfra.core.behavior.GoalDelegation;
import org.dfra.core.chain.DelayedTaskExecutor;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleDependency;
import org.dfra.geometry.GeoPosition;
import org.dfra.module.NotReadyException;
import org.dfra.recruit.agent.RobotPort.TravelListener;
import org.dfra.recruit.agent.TripStore.StartedLeg;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/**
 * A robot's trip to a place with its {@link GoToWaypoint}: started as soon as that accepts the
 * goal, polled twice a second, and reported at its end. Confined to the task thread, except {@link
 * #close}.
 *
 * <p>The behaviour that drives runs in another process, which does not end and is not suspended
 * with this one. So each goal carries the remaining time of the robot's task lease as its time
 * limit; and the goal's name is stored, so that the next process either continues it or ends it.
 * This fails if the process crashes within the milliseconds between the start and the write.
 */
final class WaypointTrip {

  /** Polling period. */
  static final long POLL_INTERVAL_NANOS = 500_000_000;

  private final String path;
  private final ModuleContext context;
  private final TripStore memory;
  private final DelayedTaskExecutor taskExecutor;
  private final GoalDelegation<LegGoal, GoToWaypoint> travel;
  private final InterruptedSearches work;
  private final OperatorHold hold;
  private final Logger log;
  private final Scheduler time;
  private volatile @Nullable UUID last; // its last goal
  private @Nullable TravelListener journey;
  private long leaseEnd; // of the trip, nanoseconds
  private boolean isExtended; // the behaviour does not know it yet
  private @Nullable LegGoal aim; // of the last trip
  private @Nullable EmergencyStopSnapshot stops; // at the request; null until the drives respond
  private @Nullable StartedLeg inherited; // until it is known whether that still runs
  private boolean isCancelScheduled; // as soon as possible
  private volatile boolean isOver;

  /**
   * @param work is interrupted where it still uses the behaviour, and stays so after an operator's
   *     stop of the trip
   * @param hold decides whether a leg may start, and records a trip whose end is unknown
   */
  WaypointTrip(
      ModuleContext context,
      DelayedTaskExecutor taskExecutor,
      InterruptedSearches work,
      OperatorHold hold,
      Logger log) {
    this.path = context.path();
    this.context = context;
    this.memory = new TripStore(context, log);
    this.taskExecutor = taskExecutor;
    this.time = context.robotTime();
    this.work = work;
    this.hold = hold;
    this.log = log;
    this.travel =
        new GoalDelegation<>(
            path,
            ModuleDependency.of(context, GoToWaypoint.class, "go_to_waypoint"),
            taskExecutor,
            log);
  }

  /** Loads the leg started by an earlier process. */
  void recall() {
    memory
        .load()
        .ifPresent(
            begun -> {
              inherited = begun;
              last = begun.goal(); // no other client started that
            });
  }

  /**
   * Adopts the leg of an earlier process, even if it has ended since, so that a stopped leg is not
   * restarted. A leg to another place is cancelled.
   *
   * @return the reason why it must not be restarted, as a clause
   */
  private Optional<String> inherit(@Nullable GeoPosition place) throws RemoteException {
    StartedLeg last = inherited;
    if (last == null) {
      return Optional.empty();
    }
    boolean isThere = place != null && last.place().equals(place.toString());
    boolean isKnown = travel.adoptWithOutcome(last.goal());
    this.last = last.goal();
    Optional<String> obstacle = Optional.empty();
    if (isKnown) {
      travel.status().ifPresent(this::onStatus);
    } else {
      obstacle = lost(travel.loss());
    }
    inherited = null;
    if (isKnown && !isThere) {
      travel.cancel();
    }
    return isThere ? obstacle : Optional.empty();
  }

  /**
   * Travels to a place; replaces any other target.
   *
   * @param end when the robot's lease of the task ends, nanoseconds of its time; {@link
   *     Long#MAX_VALUE} for never. The behaviour gets this time limit, and then stops independently
   *     of this process
   */
  void begin(LegGoal goal, long end, TravelListener listener) {
    if (!goal.equals(aim)) {
      travel.cancel();
    }
    StartedLeg last = inherited;
    stops = last != null && last.place().equals(goal.to().toString()) ? last.stops() : null;
    aim = goal;
    leaseEnd = end;
    isExtended = false;
    journey = listener;
    look(goal, listener);
  }

  /** Starts the trip if it has not started, and polls its progress until it has ended. */
  private void look(LegGoal goal, TravelListener of) {
    if (journey != of || isOver) {
      return; // it got another command
    }
    try {
      Optional<String> obstacle = inherit(goal.to());
      boolean hadBegun = travel.goal().isPresent();
      Optional<BehaviorStatus> status = travel.status();
      if (status.isPresent() && hasEnded(status.get(), of)) {
        return;
      }
      if (obstacle.isEmpty()) {
        obstacle = hadBegun && status.isEmpty() ? lost(travel.loss()) : standing();
      }
      if (obstacle.isPresent()) {
        stand(of, obstacle.get());
        return;
      } else if (status.isEmpty()) {
        begun(goal, of);
      } else if (isExtended) {
        limit();
      }
    } catch (RemoteException | NotReadyException e) {
      log.info("{}: the trip waits: {}", path, e.toString());
      waitUntilSettled();
    }
    taskExecutor.schedule(POLL_INTERVAL_NANOS, () -> look(goal, of));
  }

  /**
   * A leg of an earlier process is suspended as long as it is unknown whether the robot was stopped
   * meanwhile; then it is restarted.
   */
  private void waitUntilSettled() {
    if (!hold.isSettled() && travel.goal().isPresent()) {
      log.info("{}: it stops until it has queried all behaviours of the robot", path);
      travel.cancel();
      if (!travel.isUnresolved()) {
        memory.forget(); // the next process must not treat this as an operator's stop
      }
    }
  }

  /**
   * The leg has ended, not by this object. It may be restarted only if it is known that it was not
   * stopped.
   *
   * @return the reason why it must not, as a clause
   */
  private Optional<String> lost(GoalDelegation.GoalLoss how) throws RemoteException {
    switch (how) {
      case REPLACED:
        return Optional.of("the behaviour that drives it was given another goal");
      case FORGOTTEN:
        String why =
            "the behaviour that drives it lost its leg, so it is unknown whether the robot was stopped";
        hold.setUnknown(why);
        work.handOverToOperator();
        return Optional.of(why);
      default:
        return standing();
    }
  }

  /**
   * The reason to stop, as a clause; empty where it may continue.
   *
   * @throws RemoteException if a queried module does not respond
   */
  private Optional<String> standing() throws RemoteException {
    if (isStoppedSince()) {
      return Optional.of("it was stopped for an emergency after it was asked to come");
    }
    return hold.queryBehaviors();
  }

  /** Ends the trip; the interrupted work waits for an operator. */
  private void stand(TravelListener of, String why) {
    journey = null;
    travel.cancel();
    memory.forget();
    work.handOverToOperator();
    of.failed(why);
  }

  /** Its last goal, to distinguish others' goals from its own; any thread may call it. */
  @Nullable UUID lastGoal() {
    return last;
  }

  /**
   * Whether its drives had an emergency stop since the trip was requested, released or not. The
   * behaviour may have crashed meanwhile, so that its goal does not record it.
   */
  private boolean isStoppedSince() throws RemoteException {
    Optional<EmergencyStopSnapshot> now = EmergencyStopSnapshot.query(context);
    if (now.isEmpty()) {
      return true;
    }
    @Nullable EmergencyStopSnapshot first = stops;
    if (first == null) {
      stops = now.get();
      return false;
    }
    return first.differsFrom(now.get(), hold::lastStop);
  }

  private void begun(LegGoal goal, TravelListener of) throws RemoteException {
    boolean isLimited = leaseEnd != Long.MAX_VALUE;
    long left = isLimited ? leaseEnd - time.nanos() : Long.MAX_VALUE;
    if (left <= 0) { // this process was suspended, or waited for the behaviour
      journey = null;
      of.failed("its lease of the task has ended");
      return;
    }
    try {
      travel.start(isLimited ? goal.withTimeLimit(Duration.ofNanos(left)) : goal);
      isExtended = false;
      travel.goal().ifPresent(this::noted);
      travel.goal().ifPresent(name -> keep(name, goal));
    } catch (DelegateHeldException e) {
      stand(of, String.valueOf(e.getMessage()));
    } catch (GoalRefusedException e) {
      if (e.isBusy()) {
        work.pauseSearches(); // again: it may not have responded, or not been found
      } else {
        journey = null;
        of.failed(String.valueOf(e.getMessage()));
      }
    }
  }

  private void noted(UUID goal) {
    last = goal;
  }

  private void keep(UUID name, LegGoal goal) {
    EmergencyStopSnapshot known = stops == null ? new EmergencyStopSnapshot(Map.of()) : stops;
    memory.save(new StartedLeg(name, goal.to().toString(), known));
  }

  /** Changes the end of its task lease; the behaviour continues without a stop. */
  void extendLease(long end) {
    if (journey == null) {
      return;
    }
    leaseEnd = end;
    isExtended = true;
    try {
      limit();
    } catch (RemoteException | NotReadyException e) { // the next poll retries
      log.info(
          "{}: the behaviour that drives it has not received the renewed lease yet: {}",
          path,
          e.toString());
    }
  }

  private void limit() throws RemoteException {
    Duration left = Duration.ofNanos(Math.max(0, leaseEnd - time.nanos()));
    if (leaseEnd != Long.MAX_VALUE && travel.adjust((by, goal) -> by.setTimeLimit(goal, left))) {
      isExtended = false;
    }
  }

  /** Notifies the agent if it has ended. */
  private boolean hasEnded(BehaviorStatus status, TravelListener of) {
    if (status.phase() == Phase.RUNNING) {
      return false;
    }
    onStatus(status);
    if (status.phase() == Phase.PAUSED) { // as by a brake: the time of its resume is unknown
      travel.cancel();
    } else {
      travel.forget();
    }
    memory.forget();
    journey = null;
    if (status.phase() == Phase.SUCCEEDED) {
      of.arrived();
    } else {
      of.failed(status.activity());
    }
    return true;
  }

  /**
   * A leg was paused or cancelled by others: a person may be in front of the robot. The interrupted
   * work must not move it either.
   */
  private void onStatus(BehaviorStatus status) {
    if (status.phase() == Phase.PAUSED || status.phase() == Phase.CANCELLED) {
      work.handOverToOperator();
      if (status.heldSince() == null) { // a program did it, for an unknown client
        hold.setUnknown("its trip was stopped by a program: " + status.activity());
      }
    }
  }

  /** Cancels a trip that has not started, or not restarted, yet. */
  void giveUp(String why) {
    TravelListener waiting = journey;
    if (waiting != null) {
      end();
      waiting.failed(why);
    }
  }

  /** Stops the robot without a notification. */
  void end() {
    journey = null;
    try {
      travel.status().ifPresent(this::onStatus); // it may have been paused since the last poll
    } catch (RemoteException | NotReadyException e) {
      log.debug("{}: the status of its leg is unknown: {}", path, e.toString());
    }
    cancelTravel();
  }

  /** Retries if the behaviour does not respond, until the next trip. */
  private void cancelTravel() {
    if (journey != null) {
      return;
    }
    travel.cancel();
    try {
      Optional<String> unused = inherit(null);
      if (!travel.isUnresolved()) {
        memory.forget();
      }
    } catch (RemoteException | NotReadyException e) {
      log.debug("{}: it is not known yet whether it still drives: {}", path, e.toString());
      if (!isCancelScheduled) {
        isCancelScheduled = true;
        taskExecutor.schedule(
            POLL_INTERVAL_NANOS,
            () -> {
              isCancelScheduled = false;
              cancelTravel();
            });
      }
    }
  }

  /** Whether the ends of its trips are known, including those of an earlier process. */
  boolean isSettled() {
    return inherited == null && !travel.isUnresolved();
  }

  /** Starts nothing any more; any thread may call it. */
  void close() {
    isOver = true;
  }
}
