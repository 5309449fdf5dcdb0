package org.dfra.behaviors.waypoint;

import java.rmi.RemoteException;
import org.dfra.behavior.FollowWaypoints;
import org.dfra.behavior.GoToWaypoint;
import org.dfra.behavior.PathGoal;
import org.dfra.behaviors.raster.WaypointDistanceLimit;
import org.dfra.core.behavior.BehaviorImpl;
import org.dfra.core.behavior.GoalExecution;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleDependency;
import org.dfra.flow.perceptual.PositionEstimator;

/**
 * Drives from place to place by way of its robot's {@link GoToWaypoint}. A waypoint that is barred
 * is left out.
 *
 * <p>Its status tells how many waypoints are done: {@code done} is their number, and a part of the
 * next, by the number of all.
 *
 * <p>Parameters, read at the start:
 *
 * <ul>
 *   <li>{@code go_to_waypoint}, {@code position}, {@code drive}: names of the modules it uses;
 *       where one is not set, any of its robot that can. Of the drive it releases the parking brake
 *       when somebody asks for a path, and it gives the path up where the drive is stopped
 *   <li>{@code farthest}: metres from one waypoint to the next, and from the robot to the first; a
 *       path with more is refused, 1 to 100 000; default 2000
 *   <li>{@code rate}: as every behaviour's; default 10 Hz
 * </ul>
 */
public final class FollowWaypointsImpl extends BehaviorImpl<PathGoal> implements FollowWaypoints {

  private final ModuleDependency<GoToWaypoint> goTo;
  private final ModuleDependency<PositionEstimator> position;
  private final WaypointDistanceLimit reach;

  /** See {@link org.dfra.core.module.ModuleImpl}. */
  public FollowWaypointsImpl(ModuleContext context) {
    super(context, "drives from waypoint to waypoint", "DFRA", "1", PathGoal.class, 10);
    this.goTo = ModuleDependency.of(context, GoToWaypoint.class, "go_to_waypoint");
    this.position = ModuleDependency.of(context, PositionEstimator.class, "position");
    this.reach =
        new WaypointDistanceLimit(
            settings().number("farthest", WaypointDistanceLimit.DEFAULT.limit(), 1, 100_000));
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
