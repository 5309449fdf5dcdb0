package org.dfra.flow.sensor;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;
import org.dfra.module.Module;

/** A module that measures the world. */
public interface Sensor extends Module {

  /** How often the sensor is set to deliver a new reading, in hertz; 0 where it is only polled. */
  @Idempotent
  double updateRate() throws RemoteException;
}
