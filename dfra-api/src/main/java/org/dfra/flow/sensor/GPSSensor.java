package org.dfra.flow.sensor;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/** A satellite positioning receiver: it measures its position and the time. */
public interface GPSSensor extends LocationSensor, TimeSensor {

  /**
   * The last fix, with the quality that the receiver reports.
   *
   * @throws org.dfra.module.NotReadyException if there has been none yet
   */
  @Idempotent
  GpsFix fix() throws RemoteException;
}
