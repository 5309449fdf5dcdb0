package org.dfra.flow.sensor;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/** A sensor of a battery: of its voltage, at least. */
public interface BatterySensor extends Sensor {

  /**
   * The battery as last measured.
   *
   * @throws org.dfra.module.NotReadyException if it was not measured, or too long ago to count
   */
  @Idempotent
  BatteryState battery() throws RemoteException;
}
