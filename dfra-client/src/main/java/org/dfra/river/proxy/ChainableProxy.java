package org.dfra.river.proxy;

import java.rmi.RemoteException;
import java.util.List;
import java.util.UUID;
import org.dfra.flow.Chainable;
import org.dfra.module.Identification;
import org.dfra.module.Module;
import org.dfra.river.remote.RemoteModule;

/**
 * Smart proxy of a module in the chain: a device or a schema.
 *
 * @param <M> the module's interface
 */
public abstract class ChainableProxy<M extends Module & Chainable> extends ModuleProxy<M>
    implements Chainable {

  private static final long serialVersionUID = 1L;

  // What a driver's class determines is constant, and is queried once.
  private final Cached<List<String>> inputTypes = new Cached<>();
  private final Cached<List<String>> outputTypes = new Cached<>();

  /** See {@link ModuleProxy#ModuleProxy}. */
  protected ChainableProxy(
      Class<M> kind, RemoteModule server, UUID id, Identification identification) {
    super(kind, server, id, identification);
  }

  @Override
  public final List<String> inputTypes() throws RemoteException {
    return inputTypes.get(target()::inputTypes);
  }

  @Override
  public final List<String> outputTypes() throws RemoteException {
    return outputTypes.get(target()::outputTypes);
  }

  @Override
  public final List<String> inputs() throws RemoteException {
    return target().inputs();
  }

  @Override
  public final List<String> outputs() throws RemoteException {
    return target().outputs();
  }

  @Override
  public final void setInputs(List<String> modules) throws RemoteException {
    target().setInputs(modules);
  }

  @Override
  public final void setOutputs(List<String> modules) throws RemoteException {
    target().setOutputs(modules);
  }
}
