package org.dfra.flow.sensor;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/** A sensor that measures its position on the earth. */
public interface LocationSensor extends Sensor {

  /**
   * The last location measured.
   *
   * @throws org.dfra.module.NotReadyException if there is none yet
   */
  @Idempotent
  LocationReading location() throws RemoteException;
}
