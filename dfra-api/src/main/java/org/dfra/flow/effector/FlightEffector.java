package org.dfra.flow.effector;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/**
 * A flight controller: it flies by itself and is told where to. Without a commander it holds its
 * place in the air; it does not fall.
 */
public interface FlightEffector extends Effector<FlightCommand> {

  /**
   * How it flies.
   *
   * @throws org.dfra.module.NotReadyException if it has not told yet, or too long ago
   */
  @Idempotent
  FlightState flightState() throws RemoteException;
}
