package org.dfra.river.phoenix;

import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationID;
import java.rmi.activation.Activator;

/** Serves proxies of inactive objects, from any computer. */
final class ActivatorService implements Activator {

  private final GroupTable registered;

  ActivatorService(GroupTable registered) {
    this.registered = registered;
  }

  @Override
  public MarshalledObject<? extends Remote> activate(ActivationID id, boolean force)
      throws ActivationException, RemoteException {
    return registered.object(id).activate(id, force);
  }
}
