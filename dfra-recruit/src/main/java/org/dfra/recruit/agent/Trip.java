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
 * A robot's way to a place by its {@link GoToWaypoint}: begun as soon as that obeys, looked at
 * twice a second, and told of at its end. Confined to the thread of the errands, but for {@link
 * #close}.
 *
 * <p>What drives is another process, which does not end with this one and is not suspended with it.
 * So each goal carries the time that is left of the robot's lease of the task; and the name of what
 * was begun is kept, and the next process either follows it, or ends it. It cannot where this one
 * dies within the milliseconds between the beginning and the writing.
 */
final class Trip {

  /** How long it waits before it looks again. */
  static final long POLL_INTERVAL_NANOS = 500_000_000;

  private final String path;
  private final ModuleContext context;
  private final TripStore memory;
  private final DelayedTaskExecutor errands;
  private final GoalDelegation<LegGoal, GoToWaypoint> travel;
  private final InterruptedSearches work;
  private final OperatorHold hold;
  private final Logger log;
  private final Scheduler time;
  private volatile @Nullable UUID last; // what it began last
  private @Nullable TravelListener journey;
  private long leaseEnd; // of the journey, nanoseconds
  private boolean isExtended; // and what drives does not know that yet
  private @Nullable LegGoal aim; // of the last journey
  private @Nullable EmergencyStopSnapshot
      stops; // when that was asked for; null until wheels answer
  private @Nullable StartedLeg inherited; // until it is known whether that is still under way
  private boolean isResting; // as soon as it can
  private volatile boolean isOver;

  /**
   * @param work is left where it still holds what drives, and stays so where a person has stopped
   *     the trip
   * @param hold says whether anything may begin, and learns of a trip of which nobody knows whether
   *     somebody stopped it
   */
  Trip(
      ModuleContext context,
      DelayedTaskExecutor errands,
      InterruptedSearches work,
      OperatorHold hold,
      Logger log) {
    this.path = context.path();
    this.context = context;
    this.memory = new TripStore(context, log);
    this.errands = errands;
    this.time = context.robotTime();
    this.work = work;
    this.hold = hold;
    this.log = log;
    this.travel =
        new GoalDelegation<>(
            path, ModuleDependency.of(context, GoToWaypoint.class, "go_to_waypoint"), errands, log);
  }

  /** Knows again what was begun in an earlier process. */
  void recall() {
    memory
        .load()
        .ifPresent(
            begun -> {
              inherited = begun;
              last = begun.goal(); // nobody else began that
            });
  }

  /**
   * Takes over what was begun in an earlier process, also where it has ended since, so that a leg
   * that somebody has stopped is not begun anew. One that led elsewhere is ended.
   *
   * @return why it may not be begun anew, as a clause
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
      travel.status().ifPresent(this::heed);
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
   * Goes there, and nowhere else any more.
   *
   * @param end when the robot's lease of the task ends, nanoseconds of its time; {@link
   *     Long#MAX_VALUE} for never. What drives it learns that, and stops it then whatever has
   *     become of this process
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

  /** Begins the journey where it has not begun, and looks how far it is, until it has ended. */
  private void look(LegGoal goal, TravelListener of) {
    if (journey != of || isOver) {
      return; // it was told to do something else
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
      log.info("{}: it waits: {}", path, e.toString());
      waitUntilSettled();
    }
    errands.schedule(POLL_INTERVAL_NANOS, () -> look(goal, of));
  }

  /**
   * A leg that an earlier process began does not go on as long as nobody knows whether somebody
   * stopped the robot meanwhile; it is begun anew then.
   */
  private void waitUntilSettled() {
    if (!hold.isSettled() && travel.goal().isPresent()) {
      log.info("{}: it stops until it has asked all behaviours of the robot", path);
      travel.cancel();
      if (!travel.isUnresolved()) {
        memory.forget(); // the next process is not to take this for a stop of somebody else
      }
    }
  }

  /**
   * What was begun is not pursued any more, and not by this object's doing. It may be begun anew
   * only where it is known that nobody stopped it.
   *
   * @return why it may not, as a clause
   */
  private Optional<String> lost(GoalDelegation.GoalLoss how) throws RemoteException {
    switch (how) {
      case REPLACED:
        return Optional.of("what drives it was given another goal");
      case FORGOTTEN:
        String why = "what drives it forgot its leg, so nobody knows whether somebody stopped it";
        hold.setUnknown(why);
        work.handOverToOperator();
        return Optional.of(why);
      default:
        return standing();
    }
  }

  /**
   * Why it has to stand, as a clause; nothing where it may go on.
   *
   * @throws RemoteException if one of those that know does not answer
   */
  private Optional<String> standing() throws RemoteException {
    if (isStoppedSince()) {
      return Optional.of("it was stopped for an emergency after it was asked to come");
    }
    return hold.queryBehaviors();
  }

  /** It goes no farther, and what it left waits for a person. */
  private void stand(TravelListener of, String why) {
    journey = null;
    travel.cancel();
    memory.forget();
    work.handOverToOperator();
    of.failed(why);
  }

  /** What it began last, so that others' goals can be told from its own; by any thread. */
  @Nullable UUID lastGoal() {
    return last;
  }

  /**
   * Whether its wheels were stopped for an emergency since it was asked to go there, released or
   * not. What drives may have died meanwhile, so that its goal does not say so.
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
    if (left <= 0) { // this process was suspended, or waited for what drives
      journey = null;
      of.failed("its lease of the task is over");
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
        work.pauseSearches(); // again: it may not have answered, or not been found
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

  /** Its lease of the task ends at another time; what drives goes on without a stop. */
  void extendLease(long end) {
    if (journey == null) {
      return;
    }
    leaseEnd = end;
    isExtended = true;
    try {
      limit();
    } catch (RemoteException | NotReadyException e) { // the next look tries again
      log.info("{}: what drives it does not know its longer lease yet: {}", path, e.toString());
    }
  }

  private void limit() throws RemoteException {
    Duration left = Duration.ofNanos(Math.max(0, leaseEnd - time.nanos()));
    if (leaseEnd != Long.MAX_VALUE && travel.adjust((by, goal) -> by.setTimeLimit(goal, left))) {
      isExtended = false;
    }
  }

  /** Where it has, the agent is told. */
  private boolean hasEnded(BehaviorStatus status, TravelListener of) {
    if (status.phase() == Phase.RUNNING) {
      return false;
    }
    heed(status);
    if (status.phase() == Phase.PAUSED) { // as by a brake: nobody knows when it goes on
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
   * A leg that was paused or cancelled by others: somebody may stand before the robot. What it left
   * to help must not move it either.
   */
  private void heed(BehaviorStatus status) {
    if (status.phase() == Phase.PAUSED || status.phase() == Phase.CANCELLED) {
      work.handOverToOperator();
      if (status.heldSince() == null) { // a program did it, on whose behalf nobody knows
        hold.setUnknown("a program stopped its trip: " + status.activity());
      }
    }
  }

  /** A journey that has not begun yet, or not anew, does not begin any more. */
  void giveUp(String why) {
    TravelListener waiting = journey;
    if (waiting != null) {
      end();
      waiting.failed(why);
    }
  }

  /** It stands where it is, and nobody is told. */
  void end() {
    journey = null;
    try {
      travel.status().ifPresent(this::heed); // it may have been paused since it was looked at
    } catch (RemoteException | NotReadyException e) {
      log.debug("{}: it does not know how its leg is: {}", path, e.toString());
    }
    rest();
  }

  /** Tries again where what drives does not answer, until there is another journey. */
  private void rest() {
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
      log.debug("{}: it does not know yet whether it still drives: {}", path, e.toString());
      if (!isResting) {
        isResting = true;
        errands.schedule(
            POLL_INTERVAL_NANOS,
            () -> {
              isResting = false;
              rest();
            });
      }
    }
  }

  /** Whether it is known what became of its trips, those of an earlier process included. */
  boolean isSettled() {
    return inherited == null && !travel.isUnresolved();
  }

  /** Begins nothing any more; by any thread. */
  void close() {
    isOver = true;
  }
}
