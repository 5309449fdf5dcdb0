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
import org.dfra.river.phoenix.access.LocalCallerGuard;
import org.jspecify.annotations.Nullable;

/** Registration and administration, for callers on this machine. */
final class SystemService implements ActivationSystem, PhoenixAdmin, ReadinessMonitor {

  private final GroupTable registered;
  private final GroupRegistry registry;
  private final PhoenixConfiguration configuration;
  private final LocalCallerGuard access;
  // A caller may call before the daemon has started: it waits until everything is exported.
  private final CompletableFuture<ActivationSystem> self = new CompletableFuture<>();
  private final CompletableFuture<ActivationMonitor> monitor = new CompletableFuture<>();
  private final CompletableFuture<Runnable> shutdown = new CompletableFuture<>();

  SystemService(
      GroupTable registered,
      GroupRegistry registry,
      PhoenixConfiguration configuration,
      LocalCallerGuard access) {
    this.registered = registered;
    this.registry = registry;
    this.configuration = configuration;
    this.access = access;
  }

  /** Admits a caller on this machine as soon as phoenix has started. */
  private ActivationSystem admit(String what) throws RemoteException {
    access.check(what);
    return self.join();
  }

  /**
   * Sets the service's own proxy and the monitor's, when both are exported. From now on callers are
   * admitted.
   *
   * @param closer begins to shut phoenix down, and does not wait for it
   */
  void exported(ActivationSystem itself, ActivationMonitor monitorProxy, Runnable closer) {
    monitor.complete(monitorProxy);
    shutdown.complete(closer);
    self.complete(itself);
  }

  @Override
  public ActivationGroupID registerGroup(ActivationGroupDesc desc)
      throws ActivationException, RemoteException {
    ActivationSystem itself = admit("registerGroup");
    return registry.registerGroup(new ActivationGroupID(itself), desc);
  }

  @Override
  public ActivationID registerObject(ActivationDesc desc)
      throws ActivationException, RemoteException {
    admit("registerObject");
    return registered.activationID(registry.registerObject(desc));
  }

  @Override
  public void unregisterObject(ActivationID id) throws ActivationException, RemoteException {
    admit("unregisterObject");
    registry.unregisterObject(registered.object(id).uid);
  }

  @Override
  public void unregisterGroup(ActivationGroupID id) throws ActivationException, RemoteException {
    admit("unregisterGroup");
    registry.unregisterGroup(id);
  }

  @Override
  public ActivationMonitor activeGroup(
      ActivationGroupID id, ActivationInstantiator group, long incarnation)
      throws ActivationException, RemoteException {
    admit("activeGroup");
    registered.group(id).reported(configuration.prepareInstantiator(group), incarnation);
    return monitor.join();
  }

  @Override
  public ActivationDesc setActivationDesc(ActivationID id, ActivationDesc desc)
      throws ActivationException, RemoteException {
    admit("setActivationDesc");
    return registry.setObjectDesc(registered.object(id).uid, desc);
  }

  @Override
  public ActivationGroupDesc setActivationGroupDesc(ActivationGroupID id, ActivationGroupDesc desc)
      throws ActivationException, RemoteException {
    admit("setActivationGroupDesc");
    return registry.setGroupDesc(id, desc);
  }

  @Override
  public ActivationDesc getActivationDesc(ActivationID id)
      throws ActivationException, RemoteException {
    admit("getActivationDesc");
    return registered.object(id).desc();
  }

  @Override
  public ActivationGroupDesc getActivationGroupDesc(ActivationGroupID id)
      throws ActivationException, RemoteException {
    admit("getActivationGroupDesc");
    return registry.groupDesc(id);
  }

  @Override
  public void shutdown() throws RemoteException {
    admit("shutdown");
    shutdown.join().run();
  }

  @Override
  public Map<ActivationGroupID, ActivationGroupDesc> getActivationGroups() throws RemoteException {
    admit("getActivationGroups");
    return registry.groupDescs();
  }

  @Override
  public Map<ActivationID, ActivationDesc> getActivatableObjects(ActivationGroupID id)
      throws java.rmi.activation.UnknownGroupException, RemoteException {
    admit("getActivatableObjects");
    return registry.objectDescs(id);
  }

  @Override
  public long minReadyMillis() throws RemoteException {
    admit("minReadyMillis");
    return configuration.restartPolicy().minReadyTime().toMillis();
  }

  @Override
  public void reportStable(ActivationID id, long incarnation)
      throws UnknownObjectException, RemoteException {
    admit("reportStable");
    registered.object(id).setStable(incarnation);
  }

  @Override
  public List<GroupStatus> groupStatus() throws RemoteException {
    admit("groupStatus");
    return registry.status();
  }

  @Override
  public List<ActivationID> activeObjects(ActivationGroupID id)
      throws ActivationException, RemoteException {
    admit("activeObjects");
    return registry.activeObjects(id);
  }

  @Override
  public @Nullable MarshalledObject<? extends Remote> activeProxy(ActivationID id)
      throws ActivationException, RemoteException {
    admit("activeProxy");
    return registered.object(id).activeProxy(id);
  }

  @Override
  public boolean unregisterInactive(ActivationID id) throws ActivationException, RemoteException {
    admit("unregisterInactive");
    return registry.unregisterInactive(registered.object(id));
  }
}
