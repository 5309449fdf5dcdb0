package org.dfra.river.server.schema;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import org.dfra.flow.perceptual.Clearance;
import org.dfra.flow.perceptual.RangeFilter;
import org.dfra.river.remote.schema.RemoteRangeFilter;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/** Activatable server of a range filter. */
public final class RangeFilterServer extends SchemaServer<RangeFilter>
    implements RemoteRangeFilter {

  /** See {@link ModuleServer#ModuleServer}. */
  public RangeFilterServer(@Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(RangeFilter.class, id, data);
  }

  @Override
  public Clearance clearance() throws RemoteException {
    return module().clearance();
  }
}
