package org.dfra.river.server.sensor;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import org.dfra.flow.sensor.BatterySensor;
import org.dfra.flow.sensor.BatteryState;
import org.dfra.river.remote.sensor.RemoteBatterySensor;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/** Activatable server of a battery's sensor. */
public final class BatteryServer extends SensorServer<BatterySensor>
    implements RemoteBatterySensor {

  /** See {@link ModuleServer#ModuleServer}. */
  public BatteryServer(@Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(BatterySensor.class, id, data);
  }

  @Override
  public BatteryState battery() throws RemoteException {
    return module().battery();
  }
}
