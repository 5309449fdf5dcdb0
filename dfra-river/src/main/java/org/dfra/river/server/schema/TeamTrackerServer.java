package org.dfra.river.server.schema;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import org.dfra.flow.perceptual.TeamPositions;
import org.dfra.flow.perceptual.TeamTracker;
import org.dfra.river.remote.schema.RemoteTeamTracker;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/** Activatable server of a team tracker. */
public final class TeamTrackerServer extends SchemaServer<TeamTracker>
    implements RemoteTeamTracker {

  /** See {@link ModuleServer#ModuleServer}. */
  public TeamTrackerServer(@Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(TeamTracker.class, id, data);
  }

  @Override
  public TeamPositions team() throws RemoteException {
    return module().team();
  }
}
