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
 * Ends modules so that another may have their device: one has ended when it has answered that its
 * driver is closed, or phoenix knows that no process has it. What does not run is not started for
 * it.
 */
final class ModuleTerminator {

  private static final Logger LOG = LoggerFactory.getLogger(ModuleTerminator.class);

  private final PhoenixAdmin admin;
  private final Duration time;

  /**
   * @param time how long the end of one module may take
   */
  ModuleTerminator(PhoenixAdmin admin, Duration time) {
    this.admin = admin;
    this.time = time;
  }

  /**
   * Ends a module until it is activated again.
   *
   * @throws NotEndedException if that is not proven in time
   */
  void deactivate(RegisteredModule module) throws ActivationException, IOException {
    deactivate(module, RetryDeadline.of(time));
  }

  /**
   * Ends a module for good: phoenix forgets it, and only then when it has ended.
   *
   * @throws NotEndedException if that is not proven in time; it stays registered
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
        return; // the answer to the first question was lost
      } catch (ActivationException e) {
        again(module, patience, e);
      }
      // Somebody called it meanwhile, so that phoenix started it again.
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
        // The last module of a group takes its virtual machine along, and the answer with it.
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

  /** One line: the causes of remote failures are printed on lines of their own. */
  private static String message(Throwable failure) {
    return String.valueOf(failure.getMessage()).lines().findFirst().orElse("").strip();
  }
}
