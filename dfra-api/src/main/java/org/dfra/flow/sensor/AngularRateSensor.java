package org.dfra.flow.sensor;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/** A rate gyro: it measures the angular rate about its z axis. */
public interface AngularRateSensor extends Sensor {

  /**
   * The last rate measured.
   *
   * @throws org.dfra.module.NotReadyException if there is none, or it is too old
   */
  @Idempotent
  AngularRate rate() throws RemoteException;
}
