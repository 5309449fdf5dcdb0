package org.dfra.flow.sensor;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/** A sensor that measures distances along beams in a plane: a scanning laser, a ring of sonars. */
public interface RangeSensor extends Sensor {

  /**
   * The last scan.
   *
   * @throws org.dfra.module.NotReadyException if there is none, or it is too old
   */
  @Idempotent
  RangeScan scan() throws RemoteException;
}
