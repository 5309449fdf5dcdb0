package org.dfra.flow.sensor;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/** A battery sensor. It measures the voltage at least. */
public interface BatterySensor extends Sensor {

  /**
   * The last measured state of the battery.
   *
   * @throws org.dfra.module.NotReadyException if it was not measured, or the measurement is too old
   */
  @Idempotent
  BatteryState battery() throws RemoteException;
}
