package org.dfra.behaviors.waypoint;

import java.rmi.RemoteException;
import java.util.List;
import java.util.Optional;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.GoToWaypoint;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.behavior.LegGoal;
import org.dfra.behavior.PathGoal;
import org.dfra.behaviors.raster.WaypointText;
import org.dfra.core.behavior.Delegation;
import org.dfra.core.behavior.DriveInterlock;
import org.dfra.core.behavior.Progress;
import org.dfra.core.behavior.Pursuit;
import org.dfra.core.chain.Errands;
import org.dfra.core.module.Needed;
import org.dfra.geometry.GeoPosition;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/** One path being driven, leg by leg. A waypoint that is barred is left out, and counted. */
final class PathPursuit implements Pursuit {

  private final String path;
  private final PathGoal goal;
  private final DriveInterlock interlock;
  private final Logger log;
  private final Delegation<LegGoal, GoToWaypoint> leg;
  private int next; // the waypoint that is being gone to
  private int missed;

  PathPursuit(
      String path,
      Needed<GoToWaypoint> goTo,
      PathGoal goal,
      DriveInterlock interlock,
      Errands errands,
      Logger log) {
    this.path = path;
    this.goal = goal;
    this.interlock = interlock;
    this.log = log;
    this.leg = new Delegation<>(path, goTo, errands, log);
  }

  @Override
  public Progress step() throws RemoteException {
    Progress progress = turn();
    return progress.missing(missed).counting(next, goal.waypoints().size());
  }

  private Progress turn() throws RemoteException {
    Optional<BehaviorStatus> driving = leg.status();
    if (driving.isEmpty()) {
      return begin();
    }
    BehaviorStatus status = driving.get();
    switch (status.phase()) {
      case SUCCEEDED:
        return reached(false);
      case FAILED:
        log.warn("{}: waypoint {} is left out: {}", path, next + 1, status.doing());
        return reached(true);
      case CANCELLED:
        return Progress.cancelled("its leg was cancelled: " + status.doing(), done(0));
      case PAUSED: // as by a brake: whoever resumes the path begins the leg anew
        return Progress.held("its leg is paused: " + status.doing(), done(0));
      default:
        return going(status.doing(), status.done());
    }
  }

  /**
   * Begins the next leg.
   *
   * @throws GoalRefusedException if somebody else uses what drives it
   * @throws org.dfra.flow.effector.StoppedCommandException if the drive was stopped for an
   *     emergency since the path was begun
   */
  private Progress begin() throws RemoteException {
    interlock.requireNotStoppedSince();
    List<GeoPosition> waypoints = goal.waypoints();
    @Nullable GeoPosition from = next == 0 ? goal.from() : waypoints.get(next - 1);
    try {
      leg.begin(new LegGoal(from, waypoints.get(next), goal.tolerance()));
    } catch (GoalRefusedException e) {
      if (e.isBusy()) { // somebody else uses it: it is waited for
        throw e;
      }
      return Progress.failed(String.valueOf(e.getMessage()), done(0));
    }
    return going("it begins a leg", 0);
  }

  private Progress reached(boolean isMissed) throws RemoteException {
    missed += isMissed ? 1 : 0;
    next++;
    leg.forget();
    if (next < goal.waypoints().size()) {
      return begin();
    }
    if (missed == goal.waypoints().size()) {
      return Progress.failed("it could get to none of its waypoints", done(0));
    }
    return Progress.reached(
        missed == 0
            ? "it has been everywhere"
            : missed + " of " + goal.waypoints().size() + " waypoints left out, barred");
  }

  private Progress going(String doing, double ofLeg) {
    return Progress.going(
        WaypointText.number(next, goal.waypoints().size()) + ": " + doing, done(ofLeg));
  }

  /** So many waypoints of all, and a part of the next. */
  private double done(double ofLeg) {
    return Math.min(1, (next + Math.min(0.99, ofLeg)) / goal.waypoints().size());
  }

  @Override
  public void rest() {
    leg.end();
  }
}
