package org.dfra.river.bootstrap;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.rmi.MarshalledObject;
import java.rmi.activation.ActivationID;
import java.util.ArrayList;
import java.util.List;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.module.ModuleClassFactory;
import org.dfra.core.robot.ResourceCloser;
import org.dfra.core.robot.ShutdownOrder;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;

/**
 * Modules that run in this virtual machine, with the same servers as in service groups, and the
 * lookup service that they join. No activation system restarts modules that have ended.
 */
public final class ServedModules implements AutoCloseable {

  private final String whose;
  private final EmbeddedRegistrar registrar;

  @GuardedBy("this")
  private final List<ModuleServer<?>> serving = new ArrayList<>();

  /**
   * @param owner owner of the modules, for messages, e.g. {@code robot atrv1}
   * @param registrar ends with the modules; the caller starts it
   */
  public ServedModules(String owner, EmbeddedRegistrar registrar) {
    this.whose = owner;
    this.registrar = registrar;
  }

  /** The lookup service, which may be ended and started again while the modules run. */
  public EmbeddedRegistrar registrar() {
    return registrar;
  }

  /**
   * Adds and exports a module.
   *
   * @throws ConfigurationException if it cannot be instantiated or exported
   * @throws IOException if it cannot be marshalled
   */
  public synchronized void serve(ModuleActivation activation) throws IOException {
    ModuleDescription module = activation.module();
    ModuleClassFactory classes = new ModuleClassFactory(module);
    Class<?> type = classes.load("server", module.serverClass());
    if (!ModuleServer.class.isAssignableFrom(type)) {
      throw classes.fault("server " + type.getName() + " is not a ModuleServer", null);
    }
    serving.add(
        ModuleServer.started(
            (ModuleServer<?>)
                classes.construct(
                    "server",
                    type,
                    new Class<?>[] {ActivationID.class, MarshalledObject.class},
                    null,
                    new MarshalledObject<>(activation))));
  }

  /**
   * Ends the modules, and then the lookup service. Effectors are halted before any module leaves
   * the lookup service; see {@link ShutdownOrder}. If one module cannot be ended, the others still
   * are; then the exception is thrown.
   */
  @Override
  public synchronized void close() throws IOException {
    ResourceCloser ending = new ResourceCloser(whose);
    List<ModuleServer<?>> order = ShutdownOrder.of(serving);
    serving.clear();
    order.forEach(ModuleServer::halt);
    order.forEach(ending::close);
    ending.close(registrar);
    ending.throwIfFailed();
  }
}
