package org.dfra.river.server.sensor;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import org.dfra.flow.sensor.RangeScan;
import org.dfra.flow.sensor.RangeSensor;
import org.dfra.river.remote.sensor.RemoteRangeSensor;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/** Activatable server of a range sensor. */
public final class RangeServer extends SensorServer<RangeSensor> implements RemoteRangeSensor {

  /** See {@link ModuleServer#ModuleServer}. */
  public RangeServer(@Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(RangeSensor.class, id, data);
  }

  @Override
  public RangeScan scan() throws RemoteException {
    return module().scan();
  }
}
