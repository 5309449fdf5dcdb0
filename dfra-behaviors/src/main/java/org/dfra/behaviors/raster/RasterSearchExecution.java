package org.dfra.behaviors.raster;

import java.rmi.RemoteException;
import java.util.List;
import java.util.Optional;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.FollowWaypoints;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.behavior.PathGoal;
import org.dfra.behaviors.raster.RasterSearchStore.DelegatedPath;
import org.dfra.core.behavior.DriveInterlock;
import org.dfra.core.behavior.GoalDelegation;
import org.dfra.core.behavior.GoalExecution;
import org.dfra.core.behavior.GoalProgress;
import org.dfra.flow.effector.CommandRefusedByEmergencyStopException;
import org.dfra.geometry.GeoPosition;
import org.dfra.module.NotReadyException;
import org.jspecify.annotations.Nullable;

/**
 * One region being searched: what is left of its waypoints is one path for {@link FollowWaypoints}.
 * The next process of a search goes on with the path that its dead one had driven.
 */
final class RasterSearchExecution implements GoalExecution {

  private final RasterPlan plan;
  private final double tolerance;
  private final GoalDelegation<PathGoal, FollowWaypoints> path;
  private final DriveInterlock interlock;
  private final ProgressRecorder counter;
  private @Nullable DelegatedPath inherited; // until it is known what has become of it
  private int reached; // waypoints that are done
  private int missed; // of those, the ones that were left out
  private int begun; // waypoints that were done when the path began
  private int missedBefore; // of those

  /** Keeps what the next process is to know. */
  interface ProgressRecorder {
    /**
     * More waypoints are done.
     *
     * @param reached waypoints that are done
     * @param missed of those, the ones that were left out, barred
     */
    void recordProgress(int reached, int missed);

    /** This path is being driven for it; null where none is any more. */
    void recordPath(@Nullable DelegatedPath path);
  }

  /**
   * @param tolerance how near each waypoint is near enough, metres
   * @param reached waypoints that are done already, less than all
   * @param missed of those, the ones that were left out
   * @param inherited what an earlier process has begun to have driven; null where it had nothing
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
    } catch (RemoteException | NotReadyException e) { // it must not be forgotten meanwhile
      return GoalProgress.inProgress(
          "it waits to learn what became of its path: " + inWords(e), done());
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
      case FAILED: // what is left may be barred, and yet the robot has been elsewhere
        boolean isAllMissed = status.skippedParts() == plan.waypoints().size() - begun;
        return isAllMissed && missed < reached
            ? searched()
            : GoalProgress.failed(status.activity(), done());
      case CANCELLED:
        if (status.heldSince() == null) { // the search's earlier process gave it up as it ended
          path.forget();
          return begin();
        }
        return GoalProgress.paused("its path was cancelled: " + status.activity(), done());
      case PAUSED: // as by a brake: whoever resumes the search has what is left begun anew
        return GoalProgress.paused("its path is paused: " + status.activity(), done());
      default:
        return GoalProgress.inProgress(
            lane() + ", " + WaypointText.positionInWhole(status, begun, plan.waypoints().size()),
            done());
    }
  }

  private static String inWords(Exception reason) {
    return reason instanceof RemoteException
        ? "what drives it does not answer"
        : String.valueOf(reason.getMessage());
  }

  /**
   * Takes over the path of the earlier process, also where it has ended since: then what was driven
   * is not driven again, and what was given up is not begun anew by itself.
   *
   * @throws RemoteException if what follows it does not answer yet; it is asked again then
   * @throws NotReadyException if that is not found yet, as at first in every new process; likewise
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
      if (e.isBusy()) { // somebody else uses it: it is waited for
        throw e;
      }
      return GoalProgress.failed(String.valueOf(e.getMessage()), done());
    }
    begun = reached;
    missedBefore = missed;
    path.goal().ifPresent(goal -> counter.recordPath(new DelegatedPath(goal, begun, missedBefore)));
    return GoalProgress.inProgress(lane() + ", it begins", done());
  }

  private void note(BehaviorStatus status) {
    int now = begun + waypointsDone(status);
    if (now > reached) {
      reached = now;
      missed = missedBefore + status.skippedParts();
      counter.recordProgress(reached, missed);
    }
  }

  /** A path that does not count them yet, of an older version, tells only their share of all. */
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
                ? "it has been everywhere"
                : missed + " of " + plan.waypoints().size() + " waypoints left out, barred"));
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
    if (earlier != null) { // nobody has answered yet what has become of it
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
