package org.dfra.behaviors.raster;

import java.rmi.RemoteException;
import java.util.List;
import java.util.Optional;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.FollowWaypoints;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.behavior.PathGoal;
import org.dfra.behaviors.raster.RasterSearchStore.DelegatedPath;
import org.dfra.behaviors.waypoint.WaypointText;
import org.dfra.core.behavior.DriveInterlock;
import org.dfra.core.behavior.GoalDelegation;
import org.dfra.core.behavior.GoalExecution;
import org.dfra.core.behavior.GoalProgress;
import org.dfra.flow.effector.CommandRefusedByEmergencyStopException;
import org.dfra.geometry.GeoPosition;
import org.dfra.module.NotReadyException;
import org.jspecify.annotations.Nullable;

/**
 * Executes one region search: its remaining waypoints are one path for {@link FollowWaypoints}.
 * After a crash, the next process continues the path of the previous one.
 */
final class RasterSearchExecution implements GoalExecution {

  private final RasterPlan plan;
  private final double tolerance;
  private final GoalDelegation<PathGoal, FollowWaypoints> path;
  private final DriveInterlock interlock;
  private final ProgressRecorder counter;
  private @Nullable DelegatedPath inherited; // until its result is known
  private int reached; // waypoints that are done
  private int missed; // of those, the skipped ones
  private int begun; // waypoints done when the path began
  private int missedBefore; // of those

  /** Stores the progress for the next process. */
  interface ProgressRecorder {
    /**
     * More waypoints are done.
     *
     * @param reached waypoints that are done
     * @param missed of those, the skipped, unreachable ones
     */
    void recordProgress(int reached, int missed);

    /** The path that is now driven for it; null where none is. */
    void recordPath(@Nullable DelegatedPath path);
  }

  /**
   * @param tolerance of each waypoint, metres
   * @param reached waypoints that are done already, less than all
   * @param missed of those, the skipped ones
   * @param inherited path delegated by an earlier process; null for none
   */
  RasterSearchExecution(
      RasterPlan plan,
      double tolerance,
      GoalDelegation<PathGoal, FollowWaypoints> path,
      DriveInterlock interlock,
      int reached,
      int missed,
      @Nullable DelegatedPath inherited,
      ProgressRecorder counter) {
    this.plan = plan;
    this.tolerance = tolerance;
    this.path = path;
    this.interlock = interlock;
    this.reached = reached;
    this.missed = missed;
    this.inherited = inherited;
    this.counter = counter;
  }

  @Override
  public GoalProgress step() throws RemoteException {
    GoalProgress progress = turn();
    return progress.withSkippedParts(missed).withParts(reached, plan.waypoints().size());
  }

  private GoalProgress turn() throws RemoteException {
    try {
      inherit();
    } catch (RemoteException | NotReadyException e) { // it must stay stored meanwhile
      return GoalProgress.inProgress("it waits for the status of its path: " + inWords(e), done());
    }
    Optional<BehaviorStatus> following = path.status();
    if (following.isEmpty()) {
      return begin();
    }
    BehaviorStatus status = following.get();
    note(status);
    switch (status.phase()) {
      case SUCCEEDED:
        return searched();
      case FAILED: // the rest may be unreachable, although others were reached
        boolean isAllMissed = status.skippedParts() == plan.waypoints().size() - begun;
        return isAllMissed && missed < reached
            ? searched()
            : GoalProgress.failed(status.activity(), done());
      case CANCELLED:
        if (status.heldSince() == null) { // the search's earlier process cancelled it on shutdown
          path.forget();
          return begin();
        }
        return GoalProgress.paused("its path was cancelled: " + status.activity(), done());
      case PAUSED: // as by a brake: a resume of the search restarts the rest
        return GoalProgress.paused("its path is paused: " + status.activity(), done());
      default:
        return GoalProgress.inProgress(
            lane() + ", " + WaypointText.positionInWhole(status, begun, plan.waypoints().size()),
            done());
    }
  }

  private static String inWords(Exception reason) {
    return reason instanceof RemoteException
        ? "the behaviour that drives it does not answer"
        : String.valueOf(reason.getMessage());
  }

  /**
   * Adopts the path of the earlier process, even if it has ended since: so driven waypoints are not
   * repeated, and a cancelled path does not restart on its own.
   *
   * @throws RemoteException if the follower does not respond yet; the call is then retried
   * @throws NotReadyException if the follower is not found yet, as at first in every new process;
   *     likewise
   */
  private void inherit() throws RemoteException {
    DelegatedPath earlier = inherited;
    if (earlier == null) {
      return;
    }
    if (path.adoptWithOutcome(earlier.goal())) {
      begun = earlier.reached();
      missedBefore = earlier.missed();
    }
    inherited = null;
  }

  private GoalProgress begin() throws RemoteException {
    try {
      interlock.requireNotStoppedSince();
    } catch (CommandRefusedByEmergencyStopException e) {
      return GoalProgress.paused(String.valueOf(e.getMessage()), done());
    }
    List<GeoPosition> all = plan.waypoints();
    @Nullable GeoPosition from = reached == 0 ? null : all.get(reached - 1);
    try {
      path.start(new PathGoal(from, all.subList(reached, all.size()), tolerance));
    } catch (GoalRefusedException e) {
      if (e.isBusy()) { // in use by another client: waits
        throw e;
      }
      return GoalProgress.failed(String.valueOf(e.getMessage()), done());
    }
    begun = reached;
    missedBefore = missed;
    path.goal().ifPresent(goal -> counter.recordPath(new DelegatedPath(goal, begun, missedBefore)));
    return GoalProgress.inProgress(lane() + ", it starts", done());
  }

  private void note(BehaviorStatus status) {
    int now = begun + waypointsDone(status);
    if (now > reached) {
      reached = now;
      missed = missedBefore + status.skippedParts();
      counter.recordProgress(reached, missed);
    }
  }

  /** A follower of an older version reports only the share of waypoints, not their number. */
  private int waypointsDone(BehaviorStatus status) {
    int waypoints = plan.waypoints().size() - begun;
    return status.totalParts() > 0
        ? Math.min(waypoints, status.completedParts())
        : (int) Math.floor(status.completion() * waypoints + 1e-6);
  }

  private GoalProgress searched() {
    return GoalProgress.reached(
        "the region is searched: "
            + (missed == 0
                ? "it has reached all waypoints"
                : missed
                    + " of "
                    + plan.waypoints().size()
                    + " waypoints skipped, since they could not be reached"));
  }

  private String lane() {
    long driven = plan.lanes().stream().filter(lane -> lane.waypoint() + 1 < reached).count();
    int lanes = plan.lanes().size();
    return "lane " + Math.min(lanes, driven + 1) + " of " + lanes;
  }

  private double done() {
    return (double) reached / plan.waypoints().size();
  }

  int reached() {
    return reached;
  }

  @Override
  public void suspend() {
    DelegatedPath earlier = inherited;
    if (earlier != null) { // its result is still unknown
      inherited = null;
      path.abandon(earlier.goal());
      return;
    }
    path.cancel();
    if (!path.isUnresolved()) {
      counter.recordPath(null);
    }
  }
}
