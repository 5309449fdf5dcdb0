package org.dfra.flow.sensor;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/** A sensor that counts the motion of wheels: it knows how far it went, and errs more and more. */
public interface OdometrySensor extends Sensor {

  /**
   * The last pose and motion counted.
   *
   * @throws org.dfra.module.NotReadyException if there is none, or none that still counts
   */
  @Idempotent
  Odometry odometry() throws RemoteException;
}
