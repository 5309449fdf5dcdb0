package org.dfra.river.phoenix;

import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationID;
import java.rmi.activation.Activator;
import java.rmi.activation.UnknownObjectException;
import java.rmi.server.UID;

/** Serves proxies of inactive objects, from any computer. */
final class ActivatorService implements Activator {

  private final PhoenixDaemon daemon;

  ActivatorService(PhoenixDaemon daemon) {
    this.daemon = daemon;
  }

  @Override
  public MarshalledObject<? extends Remote> activate(ActivationID id, boolean force)
      throws ActivationException, RemoteException {
    return object(daemon, id).activate(id, force);
  }

  /** Returns the object of an ID that this daemon created. */
  static ActivatableObject object(PhoenixDaemon daemon, ActivationID id)
      throws UnknownObjectException {
    return daemon.groupRegistry().object(uid(id));
  }

  /** Returns the object's UID within this daemon. */
  static UID uid(ActivationID id) throws UnknownObjectException {
    if (!(id instanceof JeriActivationID known)) {
      throw new UnknownObjectException("the ID " + id + " is not one of phoenix's");
    }
    return known.uid();
  }
}
