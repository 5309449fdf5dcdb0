package org.dfra.river.phoenix;

import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.ActivationMonitor;
import java.rmi.activation.UnknownGroupException;
import java.rmi.activation.UnknownObjectException;

/** Receives the groups' reports. Calls from other computers are refused. */
final class MonitorService implements ActivationMonitor {

  private final PhoenixDaemon daemon;
  private final LocalCallerGuard access;

  MonitorService(PhoenixDaemon daemon, LocalCallerGuard access) {
    this.daemon = daemon;
    this.access = access;
  }

  @Override
  public void inactiveObject(ActivationID id) throws UnknownObjectException, RemoteException {
    access.check("inactiveObject");
    daemon.groupRegistry().inactive(ActivatorService.uid(id));
  }

  @Override
  public void activeObject(ActivationID id, MarshalledObject<? extends Remote> proxy)
      throws UnknownObjectException, RemoteException {
    access.check("activeObject");
    ActivatorService.object(daemon, id).active(proxy);
  }

  @Override
  public void inactiveGroup(ActivationGroupID id, long incarnation)
      throws UnknownGroupException, RemoteException {
    access.check("inactiveGroup");
    daemon.groupRegistry().group(id).onLeaving(incarnation);
  }
}
