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
 * A robot by its own modules: its {@link RobotStateMonitor} tell where it is and how much charge it
 * has, a {@link Trip} takes it to the place, and its {@link InterruptedSearches} is what it leaves
 * and resumes. What its modules are told is told on a thread of its own, {@code dfra-body
 * robot/name}.
 */
final class ModuleRobotPort implements RobotPort, AutoCloseable {

  /** How long its end waits until the robot has been told to stand. */
  private static final long PATIENCE_MILLIS = 2000;

  private final RobotTraits traits;
  private final RobotStateMonitor senses;
  private final DelayedTaskExecutor errands;
  private final OperatorHold hold;
  private final Trip trip; // by errands only, but for what it began last
  private final InterruptedSearches work; // by errands only
  private volatile boolean isAway; // to help, or on its way; written by errands only
  private volatile boolean isStarted; // its modules can be found
  private volatile boolean isEnding; // it may not be known yet how its last trip ended
  private volatile Runnable onHold = () -> {};
  private Optional<String> reportedHold = Optional.empty(); // by errands only
  private final AtomicBoolean isClosed = new AtomicBoolean();
  private boolean isRetrying; // by errands only; to go on with its work

  ModuleRobotPort(ModuleContext context, RobotTraits traits, Logger log) {
    this.traits = traits;
    this.senses = new RobotStateMonitor(context, this::begunByOthers, log);
    this.errands = new DelayedTaskExecutor("dfra-body " + context.path(), context.robotTime());
    this.work = new InterruptedSearches(context, log);
    this.hold = new OperatorHold(context, senses, log);
    this.trip = new Trip(context, errands, work, hold, log);
  }

  /** Ends the trip of an earlier process; what that left to help stays as it is. */
  void stop() {
    errands.execute(trip::end);
  }

  /** Has this run, on the thread of the errands, whenever it is held or not any more. */
  void onHoldChange(Runnable listener) {
    onHold = listener;
  }

  void start() {
    work.load();
    trip.recall();
    hold.recall(work.hasLeft() || !trip.isSettled());
    isStarted = true;
    isEnding = !trip.isSettled();
    errands.execute(this::watchHold);
    senses.start();
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
    errands.schedule(Trip.POLL_INTERVAL_NANOS, this::watchHold);
  }

  /** Nothing of the agent's own begins while it is held, so a person began this. */
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
   * {@inheritDoc} That moves nothing: also neither a leg nor a search that waits until it is known
   * whether somebody stopped the robot.
   */
  @Override
  public void endHold() {
    hold.end();
    errands.execute(this::giveUpWhatWaits); // nothing begins before that
  }

  private void giveUpWhatWaits() {
    if (!hold.isSettled()) {
      work.handOverToOperator();
      hold.settleByPerson();
      trip.giveUp("a person let the robot go on, which moves nothing; it waits for the next call");
    }
  }

  /**
   * {@inheritDoc} The robot stands then. Where its modules hold that up for too long, the next
   * process of the agent has it stand, or goes on.
   */
  @Override
  public void close() {
    if (isClosed.getAndSet(true)) {
      return;
    }
    senses.close();
    trip.close();
    CountDownLatch stands = new CountDownLatch(1);
    errands.execute(
        () -> {
          trip.end();
          stands.countDown();
        });
    try {
      boolean unused = stands.await(PATIENCE_MILLIS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    errands.close();
  }

  @Override
  public boolean canObserve(String percept) {
    return traits.percepts().contains(percept);
  }

  /**
   * One that knows where it is, has charge left, is not held since somebody stopped it, and is not
   * sent anywhere by others may be asked. What drives it while it helps, or for its search, is its
   * own. As long as it is not known how its last trip ended, or a new process has not asked all of
   * its behaviours, somebody may have stopped it.
   */
  @Override
  public boolean isAvailable() {
    return senses.pose() != null
        && battery() > traits.batteryReserve()
        && !isEnding
        && hold.isSettled()
        && hold.reason().isEmpty()
        && (isAway || senses.isSearching() || !senses.isDriving());
  }

  @Override
  public boolean hasOwnWork() {
    return senses.isSearching();
  }

  @Override
  public boolean isInField(GeoPosition place) {
    return traits.isInField(place);
  }

  /** {@inheritDoc} By the robot's description alone; what drives it is not asked. */
  @Override
  public Optional<Duration> eta(GeoPosition place) {
    PoseEstimate here = senses.pose();
    if (here == null) {
      return Optional.empty();
    }
    double seconds = here.position().groundDistance(place) * traits.detourFactor() / traits.speed();
    return Optional.of(Duration.ofNanos((long) (seconds * 1e9)));
  }

  @Override
  public double battery() {
    return senses.battery();
  }

  @Override
  public void travelTo(HelpCall call, long leaseEnd, TravelListener listener) {
    errands.execute(
        () -> {
          isAway = true;
          isEnding = false;
          work.pauseSearches();
          trip.begin(new LegGoal(null, call.position(), traits.tolerance()), leaseEnd, listener);
        });
  }

  @Override
  public void extendLease(long leaseEnd) {
    errands.execute(() -> trip.extendLease(leaseEnd));
  }

  /** It stands where it is: its sensors see what is there. */
  @Override
  public void observe(HelpCall call) {
    errands.execute(
        () -> {
          isAway = true;
          isEnding = false;
          trip.end();
        });
  }

  @Override
  public void resumeOwnWork() {
    isEnding = true;
    errands.execute(
        () -> {
          isAway = false;
          trip.end();
          goOn();
        });
  }

  /**
   * Tries again where a search does not answer, until it is called away. As long as it is not known
   * whether somebody has stopped the robot, or the trip of an earlier process, nothing goes on.
   */
  private void goOn() {
    boolean isDone = isAway || (trip.isSettled() && isKnownWhetherHeld() && goOnUnlessHeld());
    if (!isDone && !isRetrying) {
      isRetrying = true;
      errands.schedule(
          2 * Trip.POLL_INTERVAL_NANOS,
          () -> {
            isRetrying = false;
            goOn();
          });
    }
  }

  /** A hold that is known is enough; that nothing holds it is known when all were asked. */
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
