package org.dfra.river.server;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import java.util.List;
import java.util.UUID;
import org.dfra.core.module.ModuleImpl;
import org.dfra.flow.Device;
import org.dfra.geometry.Transform;
import org.dfra.module.Diagnosis;
import org.dfra.module.Precondition;
import org.dfra.river.remote.RemoteDevice;
import org.jspecify.annotations.Nullable;

/**
 * Activatable server of a device.
 *
 * @param <D> the device's interface
 */
public abstract class DeviceServer<D extends Device> extends ChainableServer<D>
    implements RemoteDevice {

  /** Created at its first use: clients may call before ModuleServer's constructor has returned. */
  @GuardedBy("this")
  private @Nullable DiagnosticRunner examinations;

  /** See {@link ModuleServer#ModuleServer}. */
  protected DeviceServer(
      Class<D> kind, @Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(kind, id, data);
  }

  /**
   * As the other constructor, for a driver with a more specific base class.
   *
   * @param base what the driver must extend
   */
  protected DeviceServer(
      Class<D> kind,
      Class<? extends ModuleImpl> base,
      @Nullable ActivationID id,
      MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(kind, base, id, data);
  }

  private synchronized DiagnosticRunner examinations() {
    DiagnosticRunner runs = examinations;
    if (runs == null) {
      runs = new DiagnosticRunner(path(), module());
      examinations = runs;
    }
    return runs;
  }

  @Override
  public final String frame() throws RemoteException {
    return module().frame();
  }

  @Override
  public final String parentFrame() throws RemoteException {
    return module().parentFrame();
  }

  @Override
  public final Transform localTransform() throws RemoteException {
    return module().localTransform();
  }

  @Override
  public final List<Precondition> preconditions() throws RemoteException {
    return module().preconditions();
  }

  @Override
  public final List<String> tests() throws RemoteException {
    return module().tests();
  }

  /** {@inheritDoc} The call's deadline applies; a proxy has none. */
  @Override
  public final Diagnosis test(String name) throws RemoteException {
    return module().test(name);
  }

  @Override
  public final List<String> recoveries() throws RemoteException {
    return module().recoveries();
  }

  /** {@inheritDoc} The call's deadline applies; a proxy has none. */
  @Override
  public final Diagnosis recover(String name) throws RemoteException {
    return module().recover(name);
  }

  @Override
  public final UUID startDiagnostic(DiagnosticType sort, String name) throws RemoteException {
    return examinations().startRun(sort, name);
  }

  @Override
  public final @Nullable Diagnosis awaitDiagnosis(UUID run) {
    return examinations().await(run, MAX_CALL_WAIT);
  }
}
