package org.dfra.flow.sensor;

import java.rmi.RemoteException;
import org.dfra.flow.Chainable;
import org.dfra.geometry.Posable;
import org.dfra.module.Diagnosable;
import org.dfra.module.Idempotent;
import org.dfra.module.Module;

/** A module that measures the world, from the place where it is mounted. */
public interface Sensor extends Module, Posable, Diagnosable, Chainable {

  /** How often the sensor is set to deliver a new reading, in hertz; 0 where it is only polled. */
  @Idempotent
  double updateRate() throws RemoteException;
}
