package org.dfra.river.server.sensor;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.flow.sensor.CameraSensor;
import org.dfra.river.remote.sensor.RemoteCameraSensor;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/** Activatable server of a camera. */
public final class CameraServer extends SensorServer<CameraSensor> implements RemoteCameraSensor {

  /** See {@link ModuleServer#ModuleServer}. */
  public CameraServer(@Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(CameraSensor.class, id, data);
  }

  @Override
  public CameraImage image() throws RemoteException {
    return module().image();
  }
}
