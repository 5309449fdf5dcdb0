package org.dfra.river.server.behavior;

import java.rmi.MarshalledObject;
import java.rmi.activation.ActivationID;
import org.dfra.behavior.FollowWaypoints;
import org.dfra.behavior.PathGoal;
import org.dfra.river.remote.behavior.RemoteFollowWaypoints;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/** Activatable server of a behaviour that follows waypoints. */
public final class FollowWaypointsServer extends BehaviorServer<PathGoal, FollowWaypoints>
    implements RemoteFollowWaypoints {

  /** See {@link ModuleServer#ModuleServer}. */
  public FollowWaypointsServer(@Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(FollowWaypoints.class, id, data);
  }
}
