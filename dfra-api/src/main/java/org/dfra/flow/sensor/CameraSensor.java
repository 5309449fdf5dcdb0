package org.dfra.flow.sensor;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/** A camera, of visible light or of heat. */
public interface CameraSensor extends Sensor {

  /**
   * The last image taken.
   *
   * @throws org.dfra.module.NotReadyException if there is none, or none that still counts
   */
  @Idempotent
  CameraImage image() throws RemoteException;
}
