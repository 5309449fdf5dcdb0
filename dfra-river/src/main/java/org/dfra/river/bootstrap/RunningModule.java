package org.dfra.river.bootstrap;

import java.rmi.ConnectException;
import java.rmi.NoSuchObjectException;
import java.rmi.RemoteException;
import java.rmi.UnmarshalException;
import java.rmi.activation.ActivateFailedException;
import java.rmi.activation.ActivationException;
import java.util.Optional;
import org.dfra.river.remote.ModuleAdmin;
import org.dfra.river.remote.RemoteModule;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A registered module's life in its virtual machine, which is to end. Taken hold of before what is
 * registered changes, since it is reached by way of that.
 */
final class RunningModule {

  private static final Logger LOG = LoggerFactory.getLogger(RunningModule.class);

  private final Optional<ModuleAdmin> admin;

  private RunningModule(Optional<ModuleAdmin> admin) {
    this.admin = admin;
  }

  /** That of a module, which is started where it does not run; none where it does not start. */
  static RunningModule of(BootstrapLoader.Registered module) throws RemoteException {
    try {
      return new RunningModule(
          Optional.of((ModuleAdmin) ((RemoteModule) module.id().activate(false)).getAdmin()));
    } catch (ActivationException | ActivateFailedException e) {
      LOG.info("{} did not run: {}", module.activation().module().path(), e.getMessage());
      return new RunningModule(Optional.empty());
    }
  }

  /** Ends it as {@link ModuleAdmin#deactivate}; nothing happens where it did not run. */
  void deactivate() throws RemoteException {
    end(ModuleAdmin::deactivate);
  }

  /** Ends it for good, as {@code DestroyAdmin}; nothing happens where it did not run. */
  void destroy() throws RemoteException {
    end(ModuleAdmin::destroy);
  }

  private interface Ending {
    void of(ModuleAdmin admin) throws RemoteException;
  }

  private void end(Ending ending) throws RemoteException {
    if (admin.isPresent()) {
      try {
        ending.of(admin.get());
      } catch (UnmarshalException | NoSuchObjectException | ConnectException e) {
        LOG.debug("The last module of a group took its virtual machine along.", e);
      }
    }
  }
}
