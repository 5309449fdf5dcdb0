package org.dfra.activation;

import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.ActivationInstantiator;
import java.rmi.activation.ActivationMonitor;
import java.rmi.activation.ActivationSystem;
import java.rmi.activation.Activator;
import java.rmi.activation.UnknownObjectException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** An activation daemon in the test's own JVM: it records its calls, and fails on request. */
final class TestDaemon implements ActivationSystem, ActivationMonitor, Activator {

  /** The calls that it received, in order. */
  final List<String> calls = new ArrayList<>();

  final Map<ActivationID, ActivationDesc> objects = new LinkedHashMap<>();

  /** What the next activation answers with. */
  MarshalledObject<? extends Remote> live;

  ActivationInstantiator instantiator;

  /** Thrown by activeGroup, or by activeObject, if not null. */
  RemoteException unreachable;

  ActivationException refusal;

  /** So many answers of activeGroup come too late, though the group is accepted. */
  int lateAnswers;

  /** How often activeGroup was called. */
  int reports;

  ActivationMonitor monitor = this;

  @Override
  public ActivationMonitor activeGroup(
      ActivationGroupID id, ActivationInstantiator group, long incarnation)
      throws ActivationException, RemoteException {
    reports++;
    failIfAsked();
    instantiator = group;
    calls.add("activeGroup " + incarnation);
    if (lateAnswers-- > 0) {
      throw new RemoteException("no answer within the deadline");
    }
    return monitor;
  }

  private void failIfAsked() throws ActivationException, RemoteException {
    if (unreachable != null) {
      throw unreachable;
    }
    if (refusal != null) {
      throw refusal;
    }
  }

  @Override
  public ActivationID registerObject(ActivationDesc desc) {
    ActivationID id = new ActivationID(this);
    objects.put(id, desc);
    return id;
  }

  @Override
  public void unregisterObject(ActivationID id) throws UnknownObjectException {
    if (objects.remove(id) == null) {
      throw new UnknownObjectException("never registered");
    }
  }

  @Override
  public MarshalledObject<? extends Remote> activate(ActivationID id, boolean force)
      throws ActivationException, RemoteException {
    calls.add("activate " + force);
    failIfAsked();
    return live;
  }

  @Override
  public void inactiveObject(ActivationID id) {
    calls.add("inactiveObject");
  }

  @Override
  public void activeObject(ActivationID id, MarshalledObject<? extends Remote> obj)
      throws RemoteException {
    if (unreachable != null) {
      throw unreachable;
    }
    live = obj;
    calls.add("activeObject");
  }

  @Override
  public void inactiveGroup(ActivationGroupID id, long incarnation) {
    calls.add("inactiveGroup " + incarnation);
  }

  @Override
  public ActivationGroupID registerGroup(ActivationGroupDesc desc) {
    return new ActivationGroupID(this);
  }

  @Override
  public ActivationDesc getActivationDesc(ActivationID id) {
    return objects.get(id);
  }

  @Override
  public ActivationDesc setActivationDesc(ActivationID id, ActivationDesc desc) {
    return objects.put(id, desc);
  }

  @Override
  public void unregisterGroup(ActivationGroupID id) {
    throw new AssertionError("nothing tested here unregisters a group");
  }

  @Override
  public void shutdown() {
    throw new AssertionError("nothing tested here shuts the daemon down");
  }

  @Override
  public ActivationGroupDesc setActivationGroupDesc(
      ActivationGroupID id, ActivationGroupDesc desc) {
    throw new AssertionError("nothing tested here changes a group's descriptor");
  }

  @Override
  public ActivationGroupDesc getActivationGroupDesc(ActivationGroupID id) {
    throw new AssertionError("nothing tested here asks for a group's descriptor");
  }
}
