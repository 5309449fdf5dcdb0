package org.dfra.river.proxy.schema;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.flow.perceptual.Clearance;
import org.dfra.flow.perceptual.RangeFilter;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/** Smart proxy of a range filter. */
public final class RangeFilterProxy extends SchemaProxy<RangeFilter> implements RangeFilter {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  public RangeFilterProxy(RemoteModule server, UUID id, Identification identification) {
    super(RangeFilter.class, server, id, identification);
  }

  @Override
  public Clearance clearance() throws RemoteException {
    return target().clearance();
  }
}
