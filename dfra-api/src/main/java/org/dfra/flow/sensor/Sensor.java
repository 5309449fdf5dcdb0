package org.dfra.flow.sensor;

import java.rmi.RemoteException;
import org.dfra.flow.Device;
import org.dfra.module.Idempotent;

/** A module that measures the world from its mounting pose. */
public interface Sensor extends Device {

  /** The configured rate of readings in hertz; 0 if the sensor is only polled. */
  @Idempotent
  double updateRate() throws RemoteException;
}
