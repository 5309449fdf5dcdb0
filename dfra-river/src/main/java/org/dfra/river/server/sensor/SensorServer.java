package org.dfra.river.server.sensor;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import org.dfra.flow.sensor.Sensor;
import org.dfra.river.remote.sensor.RemoteSensor;
import org.dfra.river.server.DeviceServer;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/**
 * Activatable server of a sensor.
 *
 * @param <S> the sensor's interface
 */
public abstract class SensorServer<S extends Sensor> extends DeviceServer<S>
    implements RemoteSensor {

  /** See {@link ModuleServer#ModuleServer}. */
  protected SensorServer(
      Class<S> kind, @Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(kind, id, data);
  }

  @Override
  public final double updateRate() throws RemoteException {
    return module().updateRate();
  }
}
