package org.dfra.river.phoenix;

import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import java.rmi.activation.UnknownObjectException;

/**
 * Receives the reports of phoenix's groups beyond those of {@code java.rmi.activation}: which of
 * their objects are stable. Phoenix's system proxy implements it.
 */
public interface ReadinessMonitor extends Remote {

  /** How long an object must be ready without interruption to count as stable, in ms. */
  long minReadyMillis() throws RemoteException;

  /**
   * Reports that an object was ready for {@link #minReadyMillis} without interruption, in its
   * group's present incarnation. It counts as stable for the rest of that incarnation.
   *
   * @param incarnation the number given to the group's process at its start
   * @throws UnknownObjectException if it is not registered, or not any more
   */
  void reportStable(ActivationID id, long incarnation)
      throws UnknownObjectException, RemoteException;
}
