package org.dfra.example.thermometer;

import java.rmi.RemoteException;
import org.dfra.flow.sensor.Sensor;
import org.dfra.module.Idempotent;

/** A sensor that tells how warm it is. */
public interface Thermometer extends Sensor {

  /** The last temperature measured, in degrees Celsius. */
  @Idempotent
  double celsius() throws RemoteException;
}
