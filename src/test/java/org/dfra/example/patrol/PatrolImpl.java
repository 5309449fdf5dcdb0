package org.dfra.example.patrol;

import java.rmi.RemoteException;
import java.util.Optional;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.FollowWaypoints;
import org.dfra.behavior.GoToWaypoint;
import org.dfra.behavior.LegGoal;
import org.dfra.behavior.PathGoal;
import org.dfra.core.behavior.BehaviorImpl;
import org.dfra.core.behavior.GoalDelegation;
import org.dfra.core.behavior.GoalExecution;
import org.dfra.core.behavior.GoalProgress;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleDependency;
import org.dfra.geometry.GeoPosition;

/** Goes round a path. Parameter {@code rounds}: how often, 1 to 1000; default 3. */
public final class PatrolImpl extends BehaviorImpl<PathGoal> implements FollowWaypoints {

  private final ModuleDependency<GoToWaypoint> goTo;
  private final int rounds;

  public PatrolImpl(ModuleContext context) {
    super(context, "goes round a path again and again", "you", "1", PathGoal.class, 5);
    this.goTo = ModuleDependency.of(context, GoToWaypoint.class, "go_to_waypoint");
    this.rounds = (int) settings().number("rounds", 3, 1, 1000);
  }

  @Override
  protected boolean movesWheels() {
    return true; // so asking for a patrol releases the parking brake
  }

  @Override
  protected GoalExecution startGoal(PathGoal goal) {
    goTo.resolve(); // refuses where there is none, before anything moves
    return new Patrol(goal);
  }

  /** One goal: so many legs. */
  private final class Patrol implements GoalExecution {

    private final PathGoal goal;
    private final int legs;
    private final GoalDelegation<LegGoal, GoToWaypoint> leg =
        new GoalDelegation<>(path(), goTo, taskExecutor(), log);
    private int driven;

    Patrol(PathGoal goal) {
      this.goal = goal;
      this.legs = rounds * goal.waypoints().size();
    }

    @Override
    public GoalProgress step() throws RemoteException {
      Optional<BehaviorStatus> driving = leg.status();
      if (driving.isEmpty()) {
        interlock().requireNotStoppedSince(); // nobody moves it by releasing a stop
        GeoPosition next = goal.waypoints().get(driven % goal.waypoints().size());
        leg.start(new LegGoal(null, next, goal.tolerance()));
        return going("it sets out");
      }
      BehaviorStatus status = driving.get();
      switch (status.phase()) {
        case SUCCEEDED:
          leg.forget();
          driven++;
          return driven == legs ? GoalProgress.reached("the patrol is over") : going("it is there");
        case FAILED:
          return GoalProgress.failed(status.activity(), (double) driven / legs);
        case CANCELLED:
          return GoalProgress.cancelled(status.activity(), (double) driven / legs);
        case PAUSED: // as by a brake: a resumed patrol starts the leg again
          return GoalProgress.paused(status.activity(), (double) driven / legs);
        default:
          return going(status.activity());
      }
    }

    private GoalProgress going(String doing) {
      return GoalProgress.inProgress(
          "leg " + Math.min(legs, driven + 1) + " of " + legs + ": " + doing,
          (double) driven / legs);
    }

    @Override
    public void suspend() {
      leg.cancel();
    }
  }
}
