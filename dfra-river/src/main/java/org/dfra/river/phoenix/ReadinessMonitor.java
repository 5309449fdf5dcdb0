package org.dfra.river.phoenix;

import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import java.rmi.activation.UnknownObjectException;

/**
 * What phoenix's groups report beyond what {@code java.rmi.activation} has them report: which of
 * their objects have worked. Phoenix's system proxy implements it.
 */
public interface ReadinessMonitor extends Remote {

  /** How long an object has to be ready without interruption until it has worked, in ms. */
  long minReadyMillis() throws RemoteException;

  /**
   * An object has been ready for {@link #minReadyMillis} without interruption, in its group's
   * present life. Whatever becomes of it in that life, it has worked.
   *
   * @param incarnation the number given to the group's process when it was started
   * @throws UnknownObjectException if it is not registered, or not any more
   */
  void reportStable(ActivationID id, long incarnation)
      throws UnknownObjectException, RemoteException;
}
