package org.dfra.river.server.sensor;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.AngularRateSensor;
import org.dfra.river.remote.sensor.RemoteAngularRateSensor;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/** Activatable server of a rate gyro. */
public final class AngularRateServer extends SensorServer<AngularRateSensor>
    implements RemoteAngularRateSensor {

  /** See {@link ModuleServer#ModuleServer}. */
  public AngularRateServer(@Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(AngularRateSensor.class, id, data);
  }

  @Override
  public AngularRate rate() throws RemoteException {
    return module().rate();
  }
}
