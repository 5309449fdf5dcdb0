package org.dfra.river.server.sensor;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import org.dfra.flow.sensor.Odometry;
import org.dfra.flow.sensor.OdometrySensor;
import org.dfra.river.remote.sensor.RemoteOdometrySensor;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/** Activatable server of an odometry sensor. */
public final class OdometryServer extends SensorServer<OdometrySensor>
    implements RemoteOdometrySensor {

  /** See {@link ModuleServer#ModuleServer}. */
  public OdometryServer(@Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(OdometrySensor.class, id, data);
  }

  @Override
  public Odometry odometry() throws RemoteException {
    return module().odometry();
  }
}
