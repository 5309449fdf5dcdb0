package org.dfra.river.proxy.schema;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.flow.perceptual.HeadingError;
import org.dfra.flow.perceptual.HeadingPercept;
import org.dfra.geometry.Leg;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/** Smart proxy of a schema of the heading error. */
public final class HeadingErrorProxy extends SchemaProxy<HeadingError> implements HeadingError {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  public HeadingErrorProxy(RemoteModule server, UUID id, Identification identification) {
    super(HeadingError.class, server, id, identification);
  }

  @Override
  public HeadingPercept towards(Leg leg) throws RemoteException {
    return target().towards(leg);
  }
}
