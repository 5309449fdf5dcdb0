package org.dfra.behaviors.waypoint;

import java.rmi.RemoteException;
import java.util.List;
import java.util.Optional;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.GoToWaypoint;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.behavior.LegGoal;
import org.dfra.behavior.PathGoal;
import org.dfra.core.behavior.DriveInterlock;
import org.dfra.core.behavior.GoalDelegation;
import org.dfra.core.behavior.GoalExecution;
import org.dfra.core.behavior.GoalProgress;
import org.dfra.core.chain.DelayedTaskExecutor;
import org.dfra.core.module.ModuleDependency;
import org.dfra.geometry.GeoPosition;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/** Executes one path, leg by leg. It skips an unreachable waypoint and counts it. */
final class PathExecution implements GoalExecution {

  private final String path;
  private final PathGoal goal;
  private final DriveInterlock interlock;
  private final Logger log;
  private final GoalDelegation<LegGoal, GoToWaypoint> leg;
  private int next; // the current waypoint
  private int missed;

  PathExecution(
      String path,
      ModuleDependency<GoToWaypoint> goTo,
      PathGoal goal,
      DriveInterlock interlock,
      DelayedTaskExecutor taskExecutor,
      Logger log) {
    this.path = path;
    this.goal = goal;
    this.interlock = interlock;
    this.log = log;
    this.leg = new GoalDelegation<>(path, goTo, taskExecutor, log);
  }

  @Override
  public GoalProgress step() throws RemoteException {
    GoalProgress progress = turn();
    return progress.withSkippedParts(missed).withParts(next, goal.waypoints().size());
  }

  private GoalProgress turn() throws RemoteException {
    Optional<BehaviorStatus> driving = leg.status();
    if (driving.isEmpty()) {
      return begin();
    }
    BehaviorStatus status = driving.get();
    switch (status.phase()) {
      case SUCCEEDED:
        return reached(false);
      case FAILED:
        log.warn("{}: waypoint {} is skipped: {}", path, next + 1, status.activity());
        return reached(true);
      case CANCELLED:
        return GoalProgress.cancelled("its leg was cancelled: " + status.activity(), done(0));
      case PAUSED: // as by a brake: a resume of the path restarts the leg
        return GoalProgress.paused("its leg is paused: " + status.activity(), done(0));
      default:
        return going(status.activity(), status.completion());
    }
  }

  /**
   * Starts the next leg.
   *
   * @throws GoalRefusedException if another client uses the leg's behaviour
   * @throws org.dfra.flow.effector.CommandRefusedByEmergencyStopException if the drive was stopped
   *     by an emergency stop since the path's start
   */
  private GoalProgress begin() throws RemoteException {
    interlock.requireNotStoppedSince();
    List<GeoPosition> waypoints = goal.waypoints();
    @Nullable GeoPosition from = next == 0 ? goal.from() : waypoints.get(next - 1);
    try {
      leg.start(new LegGoal(from, waypoints.get(next), goal.tolerance()));
    } catch (GoalRefusedException e) {
      if (e.isBusy()) { // in use by another client: waits
        throw e;
      }
      return GoalProgress.failed(String.valueOf(e.getMessage()), done(0));
    }
    return going("it starts a leg", 0);
  }

  private GoalProgress reached(boolean isMissed) throws RemoteException {
    missed += isMissed ? 1 : 0;
    next++;
    leg.forget();
    if (next < goal.waypoints().size()) {
      return begin();
    }
    if (missed == goal.waypoints().size()) {
      return GoalProgress.failed("it could reach none of its waypoints", done(0));
    }
    return GoalProgress.reached(
        missed == 0
            ? "it has reached all waypoints"
            : missed
                + " of "
                + goal.waypoints().size()
                + " waypoints skipped, since they could not be reached");
  }

  private GoalProgress going(String doing, double ofLeg) {
    return GoalProgress.inProgress(
        WaypointText.position(next, goal.waypoints().size()) + ": " + doing, done(ofLeg));
  }

  /** Finished waypoints of all, plus the fraction of the next. */
  private double done(double ofLeg) {
    return Math.min(1, (next + Math.min(0.99, ofLeg)) / goal.waypoints().size());
  }

  @Override
  public void suspend() {
    leg.cancel();
  }
}
