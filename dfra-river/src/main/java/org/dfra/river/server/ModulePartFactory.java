package org.dfra.river.server;

import java.io.IOException;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.util.UUID;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationProvider;
import net.jini.config.EmptyConfiguration;
import net.jini.export.Exporter;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.core.module.ModuleClassFactory;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.state.StateStore;
import org.dfra.core.time.RobotTime;
import org.dfra.module.Identification;
import org.dfra.river.call.JeriExporters;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.server.Exporters.ServerSettings;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/**
 * Creates the parts that a module's description names: its configuration, driver, proxy and
 * exporter. Errors name the XML file and line.
 */
final class ModulePartFactory {

  private final ModuleActivation activation;
  private final ModuleDescription description;
  private final ModuleDirectorySupplier neighbours;
  private final ModuleClassFactory classes;

  ModulePartFactory(ModuleActivation activation) {
    this.activation = activation;
    this.description = activation.module();
    this.neighbours = new ModuleDirectorySupplier(activation);
    this.classes = new ModuleClassFactory(description);
  }

  Configuration configuration() throws net.jini.config.ConfigurationException {
    return description.configuration() == null
        ? EmptyConfiguration.INSTANCE
        : ConfigurationProvider.getInstance(new String[] {description.configuration()});
  }

  private ModuleContext context(LeaseTerms terms) {
    @Nullable String folder = activation.state();
    return new ModuleContext(
        description.robot(),
        description.name(),
        description.parameters(),
        RobotTime.clock(),
        folder == null ? StateStore.inMemory() : StateStore.inFolder(Path.of(folder)),
        terms,
        Scheduler.system(),
        neighbours);
  }

  /** The driver's access to other modules; to be closed after the driver. */
  ModuleDirectorySupplier directorySupplier() {
    return neighbours;
  }

  /**
   * Creates the driver.
   *
   * @param kind what it must implement
   * @param base what it must extend
   */
  ModuleImpl driver(LeaseTerms terms, Class<?> kind, Class<? extends ModuleImpl> base) {
    return classes.createDriver(context(terms), kind, base);
  }

  ModuleProxy<?> proxy(Class<?> kind, RemoteModule server, UUID id, Identification identification) {
    Class<?> type = classes.load("proxy", description.proxyClass());
    if (!ModuleProxy.class.isAssignableFrom(type) || !kind.isAssignableFrom(type)) {
      throw classes.fault(
          "proxy " + type.getName() + " is not a ModuleProxy that implements " + kind.getName(),
          null);
    }
    return (ModuleProxy<?>)
        classes.construct(
            "proxy",
            type,
            new Class<?>[] {RemoteModule.class, UUID.class, Identification.class},
            server,
            id,
            identification);
  }

  static Exporter exporter(Configuration configuration, ServerSettings settings)
      throws net.jini.config.ConfigurationException {
    @Nullable Exporter exporter =
        (Exporter)
            configuration.getEntry(
                ModuleServer.COMPONENT,
                "serverExporter",
                Exporter.class,
                Exporters.jeri(settings, ModuleServer.DEADLINE_MILLIS),
                settings);
    if (exporter == null) {
      throw new net.jini.config.ConfigurationException(
          ModuleServer.COMPONENT + ".serverExporter is null; leave it out to have the usual one");
    }
    try {
      return JeriExporters.requireNoDistributedGc(
          exporter, ModuleServer.COMPONENT + ".serverExporter");
    } catch (IllegalArgumentException e) {
      throw new net.jini.config.ConfigurationException(e.getMessage(), e);
    }
  }

  /** What River says of an entry, with what the called constructor or method says. */
  private static String withReason(Exception failure) {
    String message = String.valueOf(failure.getMessage());
    return failure.getCause() instanceof IllegalArgumentException reason
            && !message.contains(String.valueOf(reason.getMessage()))
        ? message + ": " + reason.getMessage()
        : message;
  }

  /** The failure as a sentence with the location of the module's description. */
  ConfigurationException withLocation(Exception failure) {
    if (failure instanceof ConfigurationException known) {
      // An omitted value has no location of its own.
      return String.valueOf(known.getMessage()).startsWith(description.path() + ":")
          ? new ConfigurationException(description.place() + ": " + known.getMessage(), known)
          : known;
    } else if (failure instanceof net.jini.config.ConfigurationException) {
      String message = withReason(failure);
      String file = String.valueOf(description.configuration());
      return classes.fault(
          "its Jini configuration "
              + (message.contains(file) ? "" : file + " ")
              + "cannot be used: "
              + message,
          failure);
    } else if (failure instanceof IOException && !(failure instanceof RemoteException)) {
      return classes.fault(String.valueOf(failure.getMessage()), failure);
    }
    return classes.fault("it cannot be served: " + failure, failure);
  }
}
