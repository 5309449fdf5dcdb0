package org.dfra.behaviors.waypoint;

import java.rmi.RemoteException;
import org.dfra.behavior.FollowWaypoints;
import org.dfra.behavior.GoToWaypoint;
import org.dfra.behavior.PathGoal;
import org.dfra.core.behavior.BehaviorImpl;
import org.dfra.core.behavior.GoalExecution;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleDependency;
import org.dfra.flow.perceptual.PositionEstimator;

/**
 * Drives along a sequence of waypoints, using its robot's {@link GoToWaypoint}. It skips an
 * unreachable waypoint.
 *
 * <p>Its status reports its progress: {@code done} is the number of finished waypoints plus the
 * finished fraction of the next, divided by the number of all.
 *
 * <p>Parameters, read at the start:
 *
 * <ul>
 *   <li>{@code go_to_waypoint}, {@code position}, {@code drive}: names of the modules to use;
 *       default any suitable one of its robot. It releases the drive's parking brake when a path is
 *       requested, and cancels the path where the drive is stopped
 *   <li>{@code max_waypoint_distance}: maximum distance between waypoints, and from the robot to
 *       the first, metres; a path beyond it is rejected, 1 to 100 000; default 2000
 *   <li>{@code rate}: as for every behaviour; default 10 Hz
 * </ul>
 */
public final class FollowWaypointsImpl extends BehaviorImpl<PathGoal> implements FollowWaypoints {

  private final ModuleDependency<GoToWaypoint> goTo;
  private final ModuleDependency<PositionEstimator> position;
  private final WaypointDistanceLimit reach;

  /** See {@link org.dfra.core.module.ModuleImpl}. */
  public FollowWaypointsImpl(ModuleContext context) {
    super(context, "drives along waypoints", "DFRA", "1", PathGoal.class, 10);
    this.goTo = ModuleDependency.of(context, GoToWaypoint.class, "go_to_waypoint");
    this.position = ModuleDependency.of(context, PositionEstimator.class, "position");
    this.reach =
        new WaypointDistanceLimit(
            settings()
                .number(
                    "max_waypoint_distance", WaypointDistanceLimit.DEFAULT.limit(), 1, 100_000));
  }

  @Override
  protected boolean movesWheels() {
    return true;
  }

  @Override
  protected GoalExecution startGoal(PathGoal goal) throws RemoteException {
    GoToWaypoint unused = goTo.resolve();
    reach.requireWithin(position.resolve().estimate().position(), goal.waypoints());
    return new PathExecution(path(), goTo, goal, interlock(), taskExecutor(), log);
  }
}
