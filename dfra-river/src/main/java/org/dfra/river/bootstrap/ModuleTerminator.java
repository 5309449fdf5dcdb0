package org.dfra.river.bootstrap;

import java.io.IOException;
import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.ServerException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.UnknownObjectException;
import java.time.Duration;
import java.util.Optional;
import org.dfra.river.bootstrap.RegisteredGroup.RegisteredModule;
import org.dfra.river.phoenix.PhoenixAdmin;
import org.dfra.river.remote.ModuleAdmin;
import org.dfra.river.remote.RemoteModule;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Ends modules so that another module may open their device. A module has ended when it has
 * confirmed that its driver is closed, or when phoenix reports that no process has it. A module
 * that does not run is not started for this.
 */
final class ModuleTerminator {

  private static final Logger LOG = LoggerFactory.getLogger(ModuleTerminator.class);

  private final PhoenixAdmin admin;
  private final Duration time;

  /**
   * @param time time limit for the end of one module
   */
  ModuleTerminator(PhoenixAdmin admin, Duration time) {
    this.admin = admin;
    this.time = time;
  }

  /**
   * Ends a module until it is activated again.
   *
   * @throws NotEndedException if the end is not confirmed in time
   */
  void deactivate(RegisteredModule module) throws ActivationException, IOException {
    deactivate(module, RetryDeadline.of(time));
  }

  /**
   * Ends a module permanently: phoenix unregisters it only after it has ended.
   *
   * @throws NotEndedException if the end is not confirmed in time; the module stays registered
   */
  void forget(RegisteredModule module) throws ActivationException, IOException {
    RetryDeadline patience = RetryDeadline.of(time);
    while (true) {
      deactivate(module, patience);
      try {
        if (patience.call(() -> admin.unregisterInactive(module.id()))) {
          return;
        }
      } catch (UnknownObjectException e) {
        return; // the answer to the first call was lost
      } catch (ActivationException e) {
        again(module, patience, e);
      }
      // A call arrived meanwhile, so phoenix started the module again.
      if (patience.isExpired()) {
        throw new NotEndedException(module, "it is started again and again by its clients", null);
      }
    }
  }

  private void deactivate(RegisteredModule module, RetryDeadline patience)
      throws ActivationException, IOException {
    while (true) {
      try {
        Optional<MarshalledObject<? extends Remote>> proxy =
            patience.call(() -> Optional.ofNullable(admin.activeProxy(module.id())));
        if (proxy.isEmpty()) {
          return;
        }
        RemoteModule server = (RemoteModule) proxy.get().get();
        ((ModuleAdmin) patience.call(server::getAdmin)).deactivate();
        return;
      } catch (UnknownObjectException e) {
        return;
      } catch (ServerException e) {
        throw new NotEndedException(module, message(e.getCause() == null ? e : e.getCause()), e);
      } catch (ClassNotFoundException e) {
        throw new NotEndedException(module, "its classes are not here (" + message(e) + ")", e);
      } catch (RemoteException | ActivationException e) {
        // The last module of a group ends its virtual machine, so the answer is lost.
        again(module, patience, e);
      }
    }
  }

  private static void again(RegisteredModule module, RetryDeadline patience, Exception failure)
      throws NotEndedException {
    LOG.debug("{} is asked again to end.", module.activation().module().path(), failure);
    if (patience.isExpired()) {
      throw new NotEndedException(module, message(failure), failure);
    }
    patience.pause();
  }

  /** One line: remote exceptions print their causes on lines of their own. */
  private static String message(Throwable failure) {
    return String.valueOf(failure.getMessage()).lines().findFirst().orElse("").strip();
  }
}
