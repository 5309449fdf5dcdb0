package org.dfra.river.server.sensor;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.LocationReading;
import org.dfra.flow.sensor.TimeReading;
import org.dfra.river.remote.sensor.RemoteGPSSensor;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/** Activatable server of a satellite positioning receiver. */
public final class GPSServer extends SensorServer<GPSSensor> implements RemoteGPSSensor {

  /** See {@link ModuleServer#ModuleServer}. */
  public GPSServer(@Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(GPSSensor.class, id, data);
  }

  @Override
  public GpsFix fix() throws RemoteException {
    return module().fix();
  }

  @Override
  public LocationReading location() throws RemoteException {
    return module().location();
  }

  @Override
  public TimeReading time() throws RemoteException {
    return module().time();
  }
}
