package org.dfra.flow.sensor;

import java.rmi.RemoteException;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalPosition;
import org.dfra.module.Idempotent;

/** A satellite positioning receiver that also tells where it is in metres about a datum. */
public interface LocalGPSSensor extends GPSSensor {

  /**
   * The last fix, east, north and up of a datum, in metres.
   *
   * @param datum where east, north and up are zero, frame WGS84
   * @throws org.dfra.module.NotReadyException if there is no position
   */
  @Idempotent
  LocalPosition localPosition(GeoPosition datum) throws RemoteException;
}
