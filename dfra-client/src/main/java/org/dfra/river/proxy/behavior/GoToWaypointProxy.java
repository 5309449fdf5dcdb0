package org.dfra.river.proxy.behavior;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.UUID;
import org.dfra.behavior.GoToWaypoint;
import org.dfra.behavior.LegGoal;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/** Smart proxy of a behaviour that goes to a waypoint. */
public final class GoToWaypointProxy extends BehaviorProxy<LegGoal, GoToWaypoint>
    implements GoToWaypoint {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  public GoToWaypointProxy(RemoteModule server, UUID id, Identification identification) {
    super(GoToWaypoint.class, server, id, identification);
  }

  @Override
  public void setTimeLimit(UUID goal, Duration limit) throws RemoteException {
    target().setTimeLimit(goal, limit);
  }
}
