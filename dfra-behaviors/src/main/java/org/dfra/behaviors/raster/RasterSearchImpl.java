package org.dfra.behaviors.raster;

import java.io.IOException;
import java.rmi.RemoteException;
import java.util.Objects;
import java.util.Optional;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.FollowWaypoints;
import org.dfra.behavior.RasterGoal;
import org.dfra.behavior.RasterSearch;
import org.dfra.behaviors.raster.RasterMemory.Begun;
import org.dfra.behaviors.raster.RasterMemory.PathBegun;
import org.dfra.core.behavior.BehaviorImpl;
import org.dfra.core.behavior.Delegation;
import org.dfra.core.behavior.Progress;
import org.dfra.core.behavior.Pursuit;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.Needed;
import org.dfra.flow.perceptual.PositionEstimator;
import org.dfra.geometry.GeoPosition;
import org.dfra.module.NotReadyException;
import org.jspecify.annotations.Nullable;

/**
 * Searches a region lane by lane, by way of its robot's {@link FollowWaypoints}. It keeps what it
 * has done: when its process dies at work, the next one goes on with the path that is being driven;
 * when it was ended in good order, or paused, the next one waits to be resumed. Where somebody
 * gives up its path, an effector is stopped for an emergency, or a brake is set, it pauses.
 *
 * <p>Parameters, read at the start:
 *
 * <ul>
 *   <li>{@code go_on}: whether it goes on by itself after its process has died, {@code true} or
 *       {@code false}; default {@code true}
 *   <li>{@code tolerance}: how near a waypoint is near enough, metres, 0.05 to 10; default 0.4
 *   <li>{@code farthest}: metres from one waypoint to the next, and from the robot to the first; a
 *       region with more is refused, 1 to 100 000; default 2000
 *   <li>{@code follow_waypoints}, {@code position}, {@code drive}: names of the modules it uses;
 *       where one is not set, any of its robot that can
 * </ul>
 */
public final class RasterSearchImpl extends BehaviorImpl<RasterGoal> implements RasterSearch {

  private final Needed<FollowWaypoints> follow;
  private final Needed<PositionEstimator> position;
  private final Reach reach;
  private final RasterMemory memory;
  private final boolean goesOn;
  private final double tolerance;

  /** Guards what is remembered, and the writing of it. */
  private final Object remembering = new Object();

  private @Nullable RasterGoal goal; // guarded by remembering
  private int reached; // guarded by remembering
  private int missed; // guarded by remembering
  private @Nullable PathBegun driven; // guarded by remembering
  private Phase phase = Phase.IDLE; // guarded by remembering

  /** See {@link org.dfra.core.module.ModuleImpl}. */
  public RasterSearchImpl(ModuleContext context) {
    super(context, "searches a region lane by lane", "DFRA", "1", RasterGoal.class, 5);
    this.follow = Needed.of(context, FollowWaypoints.class, "follow_waypoints");
    this.position = Needed.of(context, PositionEstimator.class, "position");
    this.reach = new Reach(settings().number("farthest", Reach.DEFAULT.limit(), 1, 100_000));
    this.memory = new RasterMemory(context.state());
    this.tolerance = settings().number("tolerance", 0.4, 0.05, 10);
    String text = settings().find("go_on").orElse("true").strip();
    if (!text.equals("true") && !text.equals("false")) {
      throw settings().fault("go_on", "true or false", null);
    }
    this.goesOn = text.equals("true");
  }

  @Override
  protected boolean movesWheels() {
    return true;
  }

  @Override
  protected Pursuit begin(RasterGoal wanted) throws RemoteException {
    RasterPlan plan = RasterPlan.of(wanted);
    FollowWaypoints unused = follow.now();
    requireInReach(plan);
    return pursuit(plan, wanted, 0, 0, null);
  }

  /**
   * Whoever asks for what is out of reach is to hear of it at once. A robot that does not know yet
   * where it is takes the goal; what follows the path refuses then what is too far.
   */
  private void requireInReach(RasterPlan plan) throws RemoteException {
    GeoPosition here;
    try {
      here = position.now().estimate().position();
    } catch (NotReadyException e) {
      log.debug("{}: it is not known yet how far the region is: {}", path(), e.getMessage());
      return;
    }
    reach.require(here, plan.waypoints());
  }

  private Pursuit pursuit(
      RasterPlan plan, RasterGoal wanted, int done, int leftOut, @Nullable PathBegun path) {
    synchronized (remembering) {
      driven = path;
      goal = wanted;
      reached = done;
      missed = leftOut;
    }
    return new RasterPursuit(
        plan,
        tolerance,
        new Delegation<>(path(), follow, errands(), log),
        interlock(),
        done,
        leftOut,
        path,
        new Kept());
  }

  /** What a pursuit has kept for the next process. */
  private final class Kept implements RasterPursuit.Counter {

    @Override
    public void count(int done, int leftOut) {
      synchronized (remembering) {
        reached = done;
        missed = leftOut;
        keep();
      }
    }

    @Override
    public void drives(@Nullable PathBegun path) {
      synchronized (remembering) {
        if (!Objects.equals(path, driven)) {
          driven = path;
          keep();
        }
      }
    }
  }

  @Override
  protected void onPhase(Phase now) {
    synchronized (remembering) {
      phase = now;
      keep();
    }
  }

  /** Holds the lock. */
  private void keep() {
    @Nullable RasterGoal wanted = goal;
    try {
      if (phase.isUnderWay() && wanted != null) {
        memory.keep(new Begun(wanted, reached, missed, phase, driven, interlock().seen()));
      } else {
        goal = null;
        memory.forget();
      }
    } catch (IOException e) {
      log.warn("{}: the next process would not know how far it is: {}", path(), e.toString());
      survived(e);
    }
  }

  @Override
  protected void onStart() {
    super.onStart();
    try {
      Optional<Begun> begun = memory.recall();
      if (begun.isPresent()) {
        goOn(begun.get());
      }
    } catch (IOException | IllegalArgumentException e) {
      log.warn("{}: it does not go on with what it was at: {}", path(), e.toString());
      survived(e);
    }
  }

  private void goOn(Begun begun) {
    RasterPlan plan = RasterPlan.of(begun.goal());
    int done = Math.min(begun.reached(), plan.waypoints().size() - 1);
    int leftOut = Math.min(begun.missed(), done);
    interlock().restore(begun.seen());
    Phase next = goesOn ? begun.phase() : Phase.PAUSED;
    Pursuit again = pursuit(plan, begun.goal(), done, leftOut, begun.path());
    if (next == Phase.PAUSED && begun.path() != null) {
      again.rest(); // nobody drives on for a search that is paused
    }
    int all = plan.waypoints().size();
    goOn(again, next, Progress.going("", (double) done / all).missing(leftOut).counting(done, all));
  }

  /** {@inheritDoc} One that is ended in good order waits, when it is back, to be resumed. */
  @Override
  protected void onClose() {
    pause();
    super.onClose();
  }
}
