package org.dfra.flow.sensor;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/** A sensor that integrates the motion of wheels. Its error grows with the distance. */
public interface OdometrySensor extends Sensor {

  /**
   * The last pose and velocity.
   *
   * @throws org.dfra.module.NotReadyException if there is none, or it is too old
   */
  @Idempotent
  Odometry odometry() throws RemoteException;
}
