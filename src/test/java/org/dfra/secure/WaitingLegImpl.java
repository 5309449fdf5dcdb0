package org.dfra.secure;

import java.time.Duration;
import java.util.UUID;
import org.dfra.behavior.GoToWaypoint;
import org.dfra.behavior.LegGoal;
import org.dfra.core.behavior.BehaviorImpl;
import org.dfra.core.behavior.GoalExecution;
import org.dfra.core.behavior.GoalProgress;
import org.dfra.core.module.ModuleContext;

/** A behaviour that takes each goal and never reaches it. */
public final class WaitingLegImpl extends BehaviorImpl<LegGoal> implements GoToWaypoint {

  /** Called by the module's server. */
  public WaitingLegImpl(ModuleContext context) {
    super(context, "Behaviour that waits", "somebody", "1.0", LegGoal.class, 10);
  }

  @Override
  protected GoalExecution startGoal(LegGoal goal) {
    return new GoalExecution() {
      @Override
      public GoalProgress step() {
        return GoalProgress.inProgress("it waits", 0);
      }

      @Override
      public void suspend() {}
    };
  }

  @Override
  public void setTimeLimit(UUID goal, Duration limit) {}
}
