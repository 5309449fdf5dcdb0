package org.dfra.flow.sensor;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/** A sensor that measures the time more accurately than the robot's own clock. */
public interface TimeSensor extends Sensor {

  /**
   * The last time received, with the robot's own clock at that moment.
   *
   * @throws org.dfra.module.NotReadyException if there is none yet
   */
  @Idempotent
  TimeReading time() throws RemoteException;
}
