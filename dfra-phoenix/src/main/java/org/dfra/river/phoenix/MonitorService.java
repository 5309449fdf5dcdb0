package org.dfra.river.phoenix;

import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.ActivationMonitor;
import java.rmi.activation.UnknownGroupException;
import java.rmi.activation.UnknownObjectException;
import org.dfra.river.phoenix.access.LocalCallerGuard;

/** Receives the groups' reports. Calls from other computers are refused. */
final class MonitorService implements ActivationMonitor {

  private final GroupTable registered;
  private final GroupRegistry registry;
  private final LocalCallerGuard access;

  MonitorService(GroupTable registered, GroupRegistry registry, LocalCallerGuard access) {
    this.registered = registered;
    this.registry = registry;
    this.access = access;
  }

  @Override
  public void inactiveObject(ActivationID id) throws UnknownObjectException, RemoteException {
    access.check("inactiveObject");
    registry.inactive(GroupTable.uid(id));
  }

  @Override
  public void activeObject(ActivationID id, MarshalledObject<? extends Remote> proxy)
      throws UnknownObjectException, RemoteException {
    access.check("activeObject");
    registered.object(id).active(proxy);
  }

  @Override
  public void inactiveGroup(ActivationGroupID id, long incarnation)
      throws UnknownGroupException, RemoteException {
    access.check("inactiveGroup");
    registered.group(id).onLeaving(incarnation);
  }
}
