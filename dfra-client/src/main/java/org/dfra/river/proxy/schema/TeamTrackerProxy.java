package org.dfra.river.proxy.schema;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.flow.perceptual.TeamPositions;
import org.dfra.flow.perceptual.TeamTracker;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/** Smart proxy of a team tracker. */
public final class TeamTrackerProxy extends SchemaProxy<TeamTracker> implements TeamTracker {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  public TeamTrackerProxy(RemoteModule server, UUID id, Identification identification) {
    super(TeamTracker.class, server, id, identification);
  }

  @Override
  public TeamPositions team() throws RemoteException {
    return target().team();
  }
}
