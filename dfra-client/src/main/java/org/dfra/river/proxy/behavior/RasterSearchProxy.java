package org.dfra.river.proxy.behavior;

import java.util.UUID;
import org.dfra.behavior.RasterGoal;
import org.dfra.behavior.RasterSearch;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/** Smart proxy of a script that searches by raster. */
public final class RasterSearchProxy extends BehaviorProxy<RasterGoal, RasterSearch>
    implements RasterSearch {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  public RasterSearchProxy(RemoteModule server, UUID id, Identification identification) {
    super(RasterSearch.class, server, id, identification);
  }
}
