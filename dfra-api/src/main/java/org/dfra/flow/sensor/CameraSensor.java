package org.dfra.flow.sensor;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/** A camera for visible light or thermal infrared. */
public interface CameraSensor extends Sensor {

  /**
   * The last image taken.
   *
   * @throws org.dfra.module.NotReadyException if there is none, or it is too old
   */
  @Idempotent
  CameraImage image() throws RemoteException;
}
