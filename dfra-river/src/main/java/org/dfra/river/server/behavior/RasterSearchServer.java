package org.dfra.river.server.behavior;

import java.rmi.MarshalledObject;
import java.rmi.activation.ActivationID;
import org.dfra.behavior.RasterGoal;
import org.dfra.behavior.RasterSearch;
import org.dfra.river.remote.behavior.RemoteRasterSearch;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/** Activatable server of a script that searches by raster. */
public final class RasterSearchServer extends BehaviorServer<RasterGoal, RasterSearch>
    implements RemoteRasterSearch {

  /** See {@link ModuleServer#ModuleServer}. */
  public RasterSearchServer(@Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(RasterSearch.class, id, data);
  }
}
