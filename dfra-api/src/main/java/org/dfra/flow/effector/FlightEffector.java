package org.dfra.flow.effector;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/**
 * A flight controller: it flies autonomously to commanded positions. Without a commander it holds
 * its position in the air; it does not fall.
 */
public interface FlightEffector extends Effector<FlightCommand> {

  /**
   * The flight state.
   *
   * @throws org.dfra.module.NotReadyException if it has not reported yet, or the last report is too
   *     old
   */
  @Idempotent
  FlightState flightState() throws RemoteException;
}
