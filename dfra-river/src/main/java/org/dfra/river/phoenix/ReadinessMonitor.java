package org.dfra.river.phoenix;

import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import java.rmi.activation.UnknownObjectException;

/**
 * What phoenix's groups report beyond what {@code java.rmi.activation} has them report: how far
 * their objects got. Phoenix's system proxy implements it.
 */
public interface ReadinessMonitor extends Remote {

  /**
   * An object is ready for the first time in its group's present life.
   *
   * @param incarnation the number given to the group's process when it was started
   * @throws UnknownObjectException if it is not registered, or not any more
   */
  void ready(ActivationID id, long incarnation) throws UnknownObjectException, RemoteException;
}
