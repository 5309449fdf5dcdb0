package org.dfra.river.proxy.sensor;

import java.rmi.RemoteException;
import java.util.UUID;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.flow.sensor.CameraSensor;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/** Smart proxy of a camera. */
public final class CameraProxy extends SensorProxy<CameraSensor> implements CameraSensor {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  public CameraProxy(RemoteModule server, UUID id, Identification identification) {
    super(CameraSensor.class, server, id, identification);
  }

  @Override
  public CameraImage image() throws RemoteException {
    return target().image();
  }
}
