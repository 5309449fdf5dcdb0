package org.dfra.river.server.schema;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.perceptual.PositionEstimator;
import org.dfra.river.remote.schema.RemotePositionEstimator;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/** Activatable server of a position estimator. */
public final class PositionEstimatorServer extends SchemaServer<PositionEstimator>
    implements RemotePositionEstimator {

  /** See {@link ModuleServer#ModuleServer}. */
  public PositionEstimatorServer(@Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(PositionEstimator.class, id, data);
  }

  @Override
  public PoseEstimate estimate() throws RemoteException {
    return module().estimate();
  }
}
