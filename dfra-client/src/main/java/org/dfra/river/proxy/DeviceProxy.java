package org.dfra.river.proxy;

import java.rmi.RemoteException;
import java.util.List;
import java.util.UUID;
import org.dfra.flow.Device;
import org.dfra.geometry.Transform;
import org.dfra.module.Diagnosis;
import org.dfra.module.Identification;
import org.dfra.module.Precondition;
import org.dfra.river.remote.RemoteDiagnostics;
import org.dfra.river.remote.RemoteDiagnostics.DiagnosticType;
import org.dfra.river.remote.RemoteModule;
import org.jspecify.annotations.Nullable;

/**
 * Smart proxy of a device. It queries constants of the device once and caches them; a module that
 * was replaced by a newer version gets a new proxy.
 *
 * @param <D> the device's interface
 */
public abstract class DeviceProxy<D extends Device> extends ChainableProxy<D> implements Device {

  private static final long serialVersionUID = 1L;

  // What a driver's class determines is constant, and is queried once.
  private final Cached<List<Precondition>> preconditions = new Cached<>();
  private final Cached<List<String>> tests = new Cached<>();
  private final Cached<List<String>> recoveries = new Cached<>();

  /** See {@link ModuleProxy#ModuleProxy}. */
  protected DeviceProxy(
      Class<D> kind, RemoteModule server, UUID id, Identification identification) {
    super(kind, server, id, identification);
  }

  @Override
  public final String frame() {
    return identification().path();
  }

  @Override
  public final String parentFrame() throws RemoteException {
    return target().parentFrame();
  }

  @Override
  public final Transform localTransform() throws RemoteException {
    return target().localTransform();
  }

  @Override
  public final List<Precondition> preconditions() throws RemoteException {
    return preconditions.get(target()::preconditions);
  }

  @Override
  public final List<String> tests() throws RemoteException {
    return tests.get(target()::tests);
  }

  @Override
  public final Diagnosis test(String name) throws RemoteException {
    D target = target();
    return target instanceof RemoteDiagnostics remote
        ? examine(remote, DiagnosticType.TEST, name)
        : target.test(name);
  }

  @Override
  public final List<String> recoveries() throws RemoteException {
    return recoveries.get(target()::recoveries);
  }

  @Override
  public final Diagnosis recover(String name) throws RemoteException {
    D target = target();
    return target instanceof RemoteDiagnostics remote
        ? examine(remote, DiagnosticType.RECOVERY, name)
        : target.recover(name);
  }

  /** Hardware takes longer than a call may, so one call starts it and others wait for it. */
  private static Diagnosis examine(RemoteDiagnostics remote, DiagnosticType sort, String name)
      throws RemoteException {
    UUID run = remote.startDiagnostic(sort, name);
    while (true) {
      @Nullable Diagnosis found = remote.awaitDiagnosis(run);
      if (found != null) {
        return found;
      }
    }
  }
}
