package org.dfra.river.proxy.schema;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.perceptual.PositionEstimator;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/** Smart proxy of a position estimator. */
public final class PositionEstimatorProxy extends SchemaProxy<PositionEstimator>
    implements PositionEstimator {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  public PositionEstimatorProxy(RemoteModule server, UUID id, Identification identification) {
    super(PositionEstimator.class, server, id, identification);
  }

  @Override
  public PoseEstimate estimate() throws RemoteException {
    return target().estimate();
  }
}
