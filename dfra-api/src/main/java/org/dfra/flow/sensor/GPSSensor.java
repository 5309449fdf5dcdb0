package org.dfra.flow.sensor;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/** A satellite positioning receiver: it tells where it is and what time it is. */
public interface GPSSensor extends LocationSensor, TimeSensor {

  /**
   * The last fix, with what the receiver says of its quality.
   *
   * @throws org.dfra.module.NotReadyException if there has been none yet
   */
  @Idempotent
  GpsFix fix() throws RemoteException;
}
