package org.dfra.river.server;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import java.util.List;
import org.dfra.core.module.ModuleImpl;
import org.dfra.flow.Chainable;
import org.dfra.module.Module;
import org.jspecify.annotations.Nullable;

/**
 * Activatable server of a module in the chain: a device or a schema.
 *
 * @param <M> the module's interface
 */
public abstract class ChainableServer<M extends Module & Chainable> extends ModuleServer<M>
    implements Chainable {

  /** See {@link ModuleServer#ModuleServer}. */
  protected ChainableServer(
      Class<M> kind, @Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(kind, id, data);
  }

  /**
   * As the other constructor, for a driver with a more specific base class.
   *
   * @param base what the driver must extend
   */
  protected ChainableServer(
      Class<M> kind,
      Class<? extends ModuleImpl> base,
      @Nullable ActivationID id,
      MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(kind, base, id, data);
  }

  @Override
  public final List<String> inputTypes() throws RemoteException {
    return module().inputTypes();
  }

  @Override
  public final List<String> outputTypes() throws RemoteException {
    return module().outputTypes();
  }

  @Override
  public final List<String> inputs() throws RemoteException {
    return module().inputs();
  }

  @Override
  public final List<String> outputs() throws RemoteException {
    return module().outputs();
  }

  @Override
  public final void setInputs(List<String> modules) throws RemoteException {
    module().setInputs(modules);
  }

  @Override
  public final void setOutputs(List<String> modules) throws RemoteException {
    module().setOutputs(modules);
  }
}
