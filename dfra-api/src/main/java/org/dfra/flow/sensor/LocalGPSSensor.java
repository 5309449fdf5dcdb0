package org.dfra.flow.sensor;

import java.rmi.RemoteException;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalPosition;
import org.dfra.module.Idempotent;

/**
 * A satellite positioning receiver that also reports its position in metres relative to a datum.
 */
public interface LocalGPSSensor extends GPSSensor {

  /**
   * The last fix, in metres east, north and up of a datum.
   *
   * @param datum the origin, frame WGS84
   * @throws org.dfra.module.NotReadyException if there is no position
   */
  @Idempotent
  LocalPosition localPosition(GeoPosition datum) throws RemoteException;
}
