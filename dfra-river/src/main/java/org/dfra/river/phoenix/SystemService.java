package org.dfra.river.phoenix;

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
import java.rmi.activation.UnknownObjectException;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import org.jspecify.annotations.Nullable;

/** Registration and administration, for callers on this machine. */
final class SystemService implements ActivationSystem, PhoenixAdmin, ReadinessMonitor {

  private final PhoenixDaemon daemon;
  private final LocalCallerGuard access;
  private final Runnable shutdown;
  // A caller may call before the daemon has started: it waits until everything is exported.
  private final CompletableFuture<ActivationSystem> self = new CompletableFuture<>();
  private final CompletableFuture<ActivationMonitor> monitor = new CompletableFuture<>();

  SystemService(PhoenixDaemon daemon, LocalCallerGuard access, Runnable shutdown) {
    this.daemon = daemon;
    this.access = access;
    this.shutdown = shutdown;
  }

  /** Admits a caller on this machine as soon as phoenix has started. */
  private ActivationSystem admit(String what) throws RemoteException {
    access.check(what);
    return self.join();
  }

  /** Sets the service's own proxy and the monitor's, when both are exported. */
  void exported(ActivationSystem itself, ActivationMonitor monitorProxy) {
    monitor.complete(monitorProxy);
    self.complete(itself);
  }

  @Override
  public ActivationGroupID registerGroup(ActivationGroupDesc desc)
      throws ActivationException, RemoteException {
    ActivationSystem itself = admit("registerGroup");
    return daemon.groupRegistry().registerGroup(new ActivationGroupID(itself), desc);
  }

  @Override
  public ActivationID registerObject(ActivationDesc desc)
      throws ActivationException, RemoteException {
    admit("registerObject");
    return daemon.groupRegistry().activationID(daemon.groupRegistry().registerObject(desc));
  }

  @Override
  public void unregisterObject(ActivationID id) throws ActivationException, RemoteException {
    admit("unregisterObject");
    daemon.groupRegistry().unregisterObject(ActivatorService.object(daemon, id).uid);
  }

  @Override
  public void unregisterGroup(ActivationGroupID id) throws ActivationException, RemoteException {
    admit("unregisterGroup");
    daemon.groupRegistry().unregisterGroup(id);
  }

  @Override
  public ActivationMonitor activeGroup(
      ActivationGroupID id, ActivationInstantiator group, long incarnation)
      throws ActivationException, RemoteException {
    admit("activeGroup");
    daemon.groupRegistry().group(id).reported(daemon.prepareInstantiator(group), incarnation);
    return monitor.join();
  }

  @Override
  public ActivationDesc setActivationDesc(ActivationID id, ActivationDesc desc)
      throws ActivationException, RemoteException {
    admit("setActivationDesc");
    return daemon.groupRegistry().setObjectDesc(ActivatorService.object(daemon, id).uid, desc);
  }

  @Override
  public ActivationGroupDesc setActivationGroupDesc(ActivationGroupID id, ActivationGroupDesc desc)
      throws ActivationException, RemoteException {
    admit("setActivationGroupDesc");
    return daemon.groupRegistry().setGroupDesc(id, desc);
  }

  @Override
  public ActivationDesc getActivationDesc(ActivationID id)
      throws ActivationException, RemoteException {
    admit("getActivationDesc");
    return ActivatorService.object(daemon, id).desc();
  }

  @Override
  public ActivationGroupDesc getActivationGroupDesc(ActivationGroupID id)
      throws ActivationException, RemoteException {
    admit("getActivationGroupDesc");
    return daemon.groupRegistry().groupDesc(id);
  }

  @Override
  public void shutdown() throws RemoteException {
    admit("shutdown");
    shutdown.run();
  }

  @Override
  public Map<ActivationGroupID, ActivationGroupDesc> getActivationGroups() throws RemoteException {
    admit("getActivationGroups");
    return daemon.groupRegistry().groupDescs();
  }

  @Override
  public Map<ActivationID, ActivationDesc> getActivatableObjects(ActivationGroupID id)
      throws java.rmi.activation.UnknownGroupException, RemoteException {
    admit("getActivatableObjects");
    return daemon.groupRegistry().objectDescs(id);
  }

  @Override
  public long minReadyMillis() throws RemoteException {
    admit("minReadyMillis");
    return daemon.configuration().restartPolicy().minReadyTime().toMillis();
  }

  @Override
  public void reportStable(ActivationID id, long incarnation)
      throws UnknownObjectException, RemoteException {
    admit("reportStable");
    ActivatorService.object(daemon, id).setStable(incarnation);
  }

  @Override
  public List<GroupStatus> groupStatus() throws RemoteException {
    admit("groupStatus");
    return daemon.groupRegistry().status();
  }

  @Override
  public List<ActivationID> activeObjects(ActivationGroupID id)
      throws ActivationException, RemoteException {
    admit("activeObjects");
    return daemon.groupRegistry().activeObjects(id);
  }

  @Override
  public @Nullable MarshalledObject<? extends Remote> activeProxy(ActivationID id)
      throws ActivationException, RemoteException {
    admit("activeProxy");
    return ActivatorService.object(daemon, id).activeProxy(id);
  }

  @Override
  public boolean unregisterInactive(ActivationID id) throws ActivationException, RemoteException {
    admit("unregisterInactive");
    return daemon.groupRegistry().unregisterInactive(ActivatorService.object(daemon, id));
  }
}
