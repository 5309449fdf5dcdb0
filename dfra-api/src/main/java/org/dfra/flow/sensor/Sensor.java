package org.dfra.flow.sensor;

import java.rmi.RemoteException;
import org.dfra.flow.Device;
import org.dfra.module.Idempotent;

/** A module that measures the world, from the place where it is mounted. */
public interface Sensor extends Device {

  /** How often the sensor is set to deliver a new reading, in hertz; 0 where it is only polled. */
  @Idempotent
  double updateRate() throws RemoteException;
}
