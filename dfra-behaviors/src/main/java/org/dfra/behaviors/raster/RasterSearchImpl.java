package org.dfra.behaviors.raster;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.rmi.RemoteException;
import java.util.Objects;
import java.util.Optional;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.FollowWaypoints;
import org.dfra.behavior.RasterGoal;
import org.dfra.behavior.RasterSearch;
import org.dfra.behaviors.raster.RasterSearchStore.DelegatedPath;
import org.dfra.behaviors.raster.RasterSearchStore.StoredSearch;
import org.dfra.behaviors.waypoint.WaypointDistanceLimit;
import org.dfra.core.behavior.BehaviorImpl;
import org.dfra.core.behavior.GoalDelegation;
import org.dfra.core.behavior.GoalExecution;
import org.dfra.core.behavior.GoalProgress;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleDependency;
import org.dfra.flow.perceptual.PositionEstimator;
import org.dfra.geometry.GeoPosition;
import org.dfra.module.NotReadyException;
import org.jspecify.annotations.Nullable;

/**
 * Searches a region lane by lane, using its robot's {@link FollowWaypoints}. It stores its
 * progress: after a crash during a search, the next process continues the current path; after a
 * normal shutdown, or if paused, the next one waits for a resume. It pauses when its path is
 * cancelled by another client, an effector is stopped by an emergency stop, or a brake is set.
 *
 * <p>Parameters, read at the start:
 *
 * <ul>
 *   <li>{@code resume_after_crash}: whether it continues automatically after a crash of its
 *       process, {@code true} or {@code false}; default {@code true}
 *   <li>{@code tolerance}: tolerance of waypoints, metres, 0.05 to 10; default 0.4
 *   <li>{@code max_waypoint_distance}: maximum distance between waypoints, and from the robot to
 *       the first, metres; a region beyond it is rejected, 1 to 100 000; default 2000
 *   <li>{@code follow_waypoints}, {@code position}, {@code drive}: names of the modules to use;
 *       default any suitable one of its robot
 * </ul>
 */
public final class RasterSearchImpl extends BehaviorImpl<RasterGoal> implements RasterSearch {

  private final ModuleDependency<FollowWaypoints> follow;
  private final ModuleDependency<PositionEstimator> position;
  private final WaypointDistanceLimit reach;
  private final RasterSearchStore memory;
  private final boolean goesOn;
  private final double tolerance;

  /** Guards the stored state and its writes. */
  private final Object remembering = new Object();

  @GuardedBy("remembering")
  private @Nullable RasterGoal goal;

  @GuardedBy("remembering")
  private int reached;

  @GuardedBy("remembering")
  private int missed;

  @GuardedBy("remembering")
  private @Nullable DelegatedPath driven;

  @GuardedBy("remembering")
  private Phase phase = Phase.IDLE;

  /** See {@link org.dfra.core.module.ModuleImpl}. */
  public RasterSearchImpl(ModuleContext context) {
    super(context, "searches a region lane by lane", "DFRA", "1", RasterGoal.class, 5);
    this.follow = ModuleDependency.of(context, FollowWaypoints.class, "follow_waypoints");
    this.position = ModuleDependency.of(context, PositionEstimator.class, "position");
    this.reach =
        new WaypointDistanceLimit(
            settings()
                .number(
                    "max_waypoint_distance", WaypointDistanceLimit.DEFAULT.limit(), 1, 100_000));
    this.memory = new RasterSearchStore(context.state());
    this.tolerance = settings().number("tolerance", 0.4, 0.05, 10);
    String text = settings().find("resume_after_crash").orElse("true").strip();
    if (!text.equals("true") && !text.equals("false")) {
      throw settings().fault("resume_after_crash", "true or false", null);
    }
    this.goesOn = text.equals("true");
  }

  @Override
  protected boolean movesWheels() {
    return true;
  }

  @Override
  protected GoalExecution startGoal(RasterGoal wanted) throws RemoteException {
    RasterPlan plan = RasterPlan.of(wanted);
    FollowWaypoints unused = follow.resolve();
    requireInReach(plan);
    return goalExecution(plan, wanted, 0, 0, null);
  }

  /**
   * Rejects a goal out of reach at once. Without a known position the robot accepts the goal; the
   * follower then rejects distant waypoints.
   */
  private void requireInReach(RasterPlan plan) throws RemoteException {
    GeoPosition here;
    try {
      here = position.resolve().estimate().position();
    } catch (NotReadyException e) {
      log.debug("{}: the distance of the region is not known yet: {}", path(), e.getMessage());
      return;
    }
    reach.requireWithin(here, plan.waypoints());
  }

  private GoalExecution goalExecution(
      RasterPlan plan, RasterGoal wanted, int done, int leftOut, @Nullable DelegatedPath path) {
    synchronized (remembering) {
      driven = path;
      goal = wanted;
      reached = done;
      missed = leftOut;
    }
    return new RasterSearchExecution(
        plan,
        tolerance,
        new GoalDelegation<>(path(), follow, taskExecutor(), log),
        interlock(),
        done,
        leftOut,
        path,
        new StoringProgressRecorder());
  }

  /** Progress stored for the next process. */
  private final class StoringProgressRecorder implements RasterSearchExecution.ProgressRecorder {

    @Override
    public void recordProgress(int done, int leftOut) {
      synchronized (remembering) {
        reached = done;
        missed = leftOut;
        keep();
      }
    }

    @Override
    public void recordPath(@Nullable DelegatedPath path) {
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

  @GuardedBy("remembering")
  private void keep() {
    @Nullable RasterGoal wanted = goal;
    try {
      if (phase.isUnderWay() && wanted != null) {
        memory.save(
            new StoredSearch(wanted, reached, missed, phase, driven, interlock().lastStop()));
      } else {
        goal = null;
        memory.forget();
      }
    } catch (IOException e) {
      log.warn(
          "{}: the search's progress cannot be stored, so it is lost after a restart: {}",
          path(),
          e.toString());
      recordException(e);
    }
  }

  @Override
  protected void onStart() {
    super.onStart();
    try {
      Optional<StoredSearch> begun = memory.load();
      if (begun.isPresent()) {
        goOn(begun.get());
      }
    } catch (IOException | IllegalArgumentException e) {
      log.warn("{}: the search from before the restart is not continued: {}", path(), e.toString());
      recordException(e);
    }
  }

  private void goOn(StoredSearch begun) {
    RasterPlan plan = RasterPlan.of(begun.goal());
    int done = Math.min(begun.reached(), plan.waypoints().size() - 1);
    int leftOut = Math.min(begun.missed(), done);
    interlock().restore(begun.seen());
    Phase next = goesOn ? begun.phase() : Phase.PAUSED;
    GoalExecution again = goalExecution(plan, begun.goal(), done, leftOut, begun.path());
    if (next == Phase.PAUSED && begun.path() != null) {
      again.suspend(); // no path continues for a paused search
    }
    int all = plan.waypoints().size();
    restoreGoal(
        again,
        next,
        GoalProgress.inProgress("", (double) done / all)
            .withSkippedParts(leftOut)
            .withParts(done, all));
  }

  /** {@inheritDoc} After a normal shutdown it waits for a resume. */
  @Override
  protected void onClose() {
    pause();
    super.onClose();
  }
}
