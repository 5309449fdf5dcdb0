package org.dfra.river.server.behavior;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import java.time.Duration;
import java.util.UUID;
import org.dfra.behavior.GoToWaypoint;
import org.dfra.behavior.LegGoal;
import org.dfra.river.remote.behavior.RemoteGoToWaypoint;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/** Activatable server of a behaviour that goes to a waypoint. */
public final class GoToWaypointServer extends BehaviorServer<LegGoal, GoToWaypoint>
    implements RemoteGoToWaypoint {

  /** See {@link ModuleServer#ModuleServer}. */
  public GoToWaypointServer(@Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(GoToWaypoint.class, id, data);
  }

  @Override
  public void setTimeLimit(UUID goal, Duration limit) throws RemoteException {
    module().setTimeLimit(goal, limit);
  }
}
