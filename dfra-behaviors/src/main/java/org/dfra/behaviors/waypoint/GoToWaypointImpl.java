package org.dfra.behaviors.waypoint;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import java.util.UUID;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.GoToWaypoint;
import org.dfra.behavior.LegGoal;
import org.dfra.core.behavior.BehaviorImpl;
import org.dfra.core.behavior.GoalExecution;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleDependency;
import org.dfra.flow.motor.FuzzyDrive;
import org.dfra.flow.perceptual.HeadingError;
import org.dfra.flow.perceptual.PositionEstimator;
import org.dfra.flow.perceptual.RangeFilter;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.Leg;
import org.dfra.module.Module;
import org.jspecify.annotations.Nullable;

/**
 * Drives along a line to its end, using the schemas of its robot. If the robot is stuck, it
 * executes a recovery manoeuvre; if that does not succeed, the leg fails. If the parking brake is
 * set during the leg, the leg is paused.
 *
 * <p>Parameters, read at the start:
 *
 * <ul>
 *   <li>{@code range_filter}, {@code heading_error}, {@code fuzzy_drive}, {@code position}, {@code
 *       drive}: names of the modules to use, each of its robot; default any suitable one
 *   <li>{@code max_waypoint_distance}: maximum distance to a waypoint, metres, beyond which it
 *       rejects the goal, 1 to 100 000; default 2000
 *   <li>{@code max_recoveries}: number of recoveries on one leg, 0 to 100; default 6
 *   <li>{@code passing_tolerance}: maximum distance beside its end at which a passed leg counts as
 *       reached, metres, 0 to 100; default 1
 *   <li>{@code max_peer_speed}: maximum speed of other robots, metres per second, 0 to 10; default
 *       0.7; see {@link ClearanceMargin}
 *   <li>{@code rate}: as for every behaviour; default 10 Hz
 * </ul>
 */
public final class GoToWaypointImpl extends BehaviorImpl<LegGoal> implements GoToWaypoint {

  private final ModuleDependency<RangeFilter> clearance;
  private final ModuleDependency<HeadingError> heading;
  private final ModuleDependency<FuzzyDrive> rules;
  private final ModuleDependency<PositionEstimator> position;
  private final WaypointDistanceLimit reach;
  private final int attempts;
  private final double overshoot;
  private final double peerSpeed;
  private volatile @Nullable LegExecution last; // that was made

  /** See {@link org.dfra.core.module.ModuleImpl}. */
  public GoToWaypointImpl(ModuleContext context) {
    super(context, "drives to a waypoint", "DFRA", "1", LegGoal.class, 10);
    this.clearance = ModuleDependency.of(context, RangeFilter.class, "range_filter");
    this.heading = ModuleDependency.of(context, HeadingError.class, "heading_error");
    this.rules = ModuleDependency.of(context, FuzzyDrive.class, "fuzzy_drive");
    this.position = ModuleDependency.of(context, PositionEstimator.class, "position");
    this.reach =
        new WaypointDistanceLimit(
            settings()
                .number(
                    "max_waypoint_distance", WaypointDistanceLimit.DEFAULT.limit(), 1, 100_000));
    this.attempts = (int) settings().number("max_recoveries", 6, 0, 100);
    this.overshoot = settings().number("passing_tolerance", 1, 0, 100);
    this.peerSpeed = settings().number("max_peer_speed", 0.7, 0, 10);
  }

  @Override
  protected boolean movesWheels() {
    return true;
  }

  @Override
  protected GoalExecution startGoal(LegGoal goal) throws RemoteException {
    for (ModuleDependency<?> each : List.of(clearance, heading, rules, interlock().drive())) {
      Module unused = each.resolve(); // rejects where one is missing
    }
    GeoPosition here = position.resolve().estimate().position();
    reach.requireWithin(here, goal.to());
    GeoPosition from = goal.from() == null ? here : goal.from();
    reach.requireWithin(here, from);
    LegExecution made =
        new LegExecution(
            new LegExecution.Dependencies(
                heading::resolve,
                clearance::resolve,
                rules::resolve,
                new LeasedDrive(interlock()),
                context().robotTime()::nanos,
                clock(),
                peerSpeed,
                attempts,
                overshoot),
            new Leg(from, goal.to()),
            goal.tolerance(),
            goal.timeLimit());
    last = made;
    return made;
  }

  @Override
  public void setTimeLimit(UUID goal, Duration limit) {
    if (limit.isNegative()) {
      throw new IllegalArgumentException("time limit " + limit.toMillis() + " ms is below 0");
    }
    @Nullable LegExecution pursued = last;
    BehaviorStatus now = status();
    if (pursued != last) { // another goal was started in between
      setTimeLimit(goal, limit);
    } else if (pursued != null && now.phase().isUnderWay() && goal.equals(now.goal())) {
      pursued.setTimeLimit(limit);
    }
  }
}
