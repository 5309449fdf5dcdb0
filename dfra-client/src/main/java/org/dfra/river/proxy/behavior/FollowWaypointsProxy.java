package org.dfra.river.proxy.behavior;

import java.util.UUID;
import org.dfra.behavior.FollowWaypoints;
import org.dfra.behavior.PathGoal;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/** Smart proxy of a behaviour that follows waypoints. */
public final class FollowWaypointsProxy extends BehaviorProxy<PathGoal, FollowWaypoints>
    implements FollowWaypoints {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  public FollowWaypointsProxy(RemoteModule server, UUID id, Identification identification) {
    super(FollowWaypoints.class, server, id, identification);
  }
}
