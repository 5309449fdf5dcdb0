package org.dfra.river.server.schema;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import org.dfra.flow.perceptual.HeadingError;
import org.dfra.flow.perceptual.HeadingPercept;
import org.dfra.geometry.Leg;
import org.dfra.river.remote.schema.RemoteHeadingError;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/** Activatable server of a schema of the heading error. */
public final class HeadingErrorServer extends SchemaServer<HeadingError>
    implements RemoteHeadingError {

  /** See {@link ModuleServer#ModuleServer}. */
  public HeadingErrorServer(@Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(HeadingError.class, id, data);
  }

  @Override
  public HeadingPercept towards(Leg leg) throws RemoteException {
    return module().towards(leg);
  }
}
