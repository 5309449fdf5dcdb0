package org.dfra.river.server;

import java.lang.reflect.InvocationTargetException;
import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.UUID;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationException;
import net.jini.config.ConfigurationProvider;
import net.jini.config.EmptyConfiguration;
import net.jini.core.lease.Lease;
import net.jini.core.lease.LeaseDeniedException;
import net.jini.export.Exporter;
import net.jini.export.ProxyAccessor;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.directory.SelfDescription;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.module.Identification;
import org.dfra.module.Module;
import org.dfra.module.Readiness;
import org.dfra.river.lease.ModuleLandlord;
import org.dfra.river.proxy.LocalModules;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.server.Exporters.ServerSettings;

/**
 * Activatable server of a module: it makes the driver and serves it to the network.
 *
 * <p>Constructing is starting, as the activation system demands: the six steps run in the
 * constructor, and if one fails, those before it are undone.
 *
 * @param <M> the module's interface
 */
public abstract class ModuleServer<M extends Module> implements RemoteModule, ProxyAccessor {

  /** Component of the entries that a module's Jini configuration may have. */
  static final String COMPONENT = "org.dfra.river.server";

  private final M module;
  private final Remote remote;
  private final ModuleLandlord landlord;
  private final String path;
  private final Deque<AutoCloseable> undo = new ArrayDeque<>();

  /**
   * Step 1: the activation system constructs the server; the other five follow.
   *
   * @param kind the module's interface
   * @param id the server's activation ID
   * @param data the server's {@link ModuleActivation}
   * @throws Exception the first step's failure, in its own words
   */
  protected ModuleServer(Class<M> kind, ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    try {
      // Step 2: the properties.
      ModuleActivation activation = data.get();
      ModuleDescription description = activation.module();
      this.path = description.path();
      Configuration configuration = configuration(description);

      // Step 3: the driver.
      ModuleImpl driver = driver(description, kind);
      undo.push(driver);
      this.module = kind.cast(driver);
      driver.start();
      LocalModules.enter(activation.id(), driver);
      undo.push(() -> LocalModules.leave(activation.id(), driver));

      // Step 4: the proxy.
      Exporter exporter = exporter(configuration, new ServerSettings(id, activation.host()));
      this.landlord =
          new ModuleLandlord(
              path, configuration, Exporters.jeri(activation.host(), DEADLINE_MILLIS));
      this.remote = exporter.export(this);
      undo.push(() -> exporter.unexport(true));
      ModuleProxy<?> proxy =
          proxy(description, (RemoteModule) remote, activation.id(), driver.identification());

      // Step 5: discovery and join.
      ModulePresence presence =
          new ModulePresence(
              new SelfDescription(
                  driver,
                  activation.host(),
                  activation.created(),
                  Instant.now(),
                  landlord::clients),
              proxy,
              activation,
              configuration);
      undo.push(presence);

      // Step 6: the landlord.
      landlord.start();
      undo.push(landlord);
    } catch (Exception | Error e) {
      close(e);
      throw e;
    }
  }

  private static Configuration configuration(ModuleDescription description)
      throws ConfigurationException {
    return description.configuration() == null
        ? EmptyConfiguration.INSTANCE
        : ConfigurationProvider.getInstance(new String[] {description.configuration()});
  }

  private static ModuleImpl driver(ModuleDescription description, Class<?> kind) throws Exception {
    Class<?> type = load(description, "driver", description.driverClass());
    if (!ModuleImpl.class.isAssignableFrom(type) || !kind.isAssignableFrom(type)) {
      throw fault(
          description,
          "driver " + type.getName() + " is no ModuleImpl that implements " + kind.getName());
    }
    return (ModuleImpl)
        construct(
            description,
            type,
            new Class<?>[] {ModuleContext.class},
            new ModuleContext(
                description.robot(),
                description.name(),
                description.parameters(),
                InstantSource.system()));
  }

  private static ModuleProxy<?> proxy(
      ModuleDescription description, RemoteModule server, UUID id, Identification identification)
      throws Exception {
    Class<?> type = load(description, "proxy", description.proxyClass());
    if (!ModuleProxy.class.isAssignableFrom(type)) {
      throw fault(description, "proxy " + type.getName() + " is no ModuleProxy");
    }
    return (ModuleProxy<?>)
        construct(
            description,
            type,
            new Class<?>[] {RemoteModule.class, UUID.class, Identification.class},
            server,
            id,
            identification);
  }

  private static Class<?> load(ModuleDescription description, String what, String name) {
    try {
      return Class.forName(name, true, Thread.currentThread().getContextClassLoader());
    } catch (ClassNotFoundException e) {
      throw fault(
          description,
          what
              + " class "
              + name
              + " is not on the group's class path; add its jar or mend the name");
    }
  }

  private static Object construct(
      ModuleDescription description, Class<?> type, Class<?>[] parameters, Object... arguments)
      throws Exception {
    try {
      return type.getConstructor(parameters).newInstance(arguments);
    } catch (NoSuchMethodException e) {
      throw fault(
          description,
          type.getName()
              + " has no public constructor "
              + java.util.Arrays.stream(parameters).map(Class::getSimpleName).toList());
    } catch (InvocationTargetException e) {
      if (e.getCause() instanceof Exception cause) {
        throw cause;
      }
      throw e;
    }
  }

  private static org.dfra.core.config.ConfigurationException fault(
      ModuleDescription description, String what) {
    return new org.dfra.core.config.ConfigurationException(
        description.place() + ": module " + description.path() + ": " + what);
  }

  private static Exporter exporter(Configuration configuration, ServerSettings settings)
      throws ConfigurationException {
    return (Exporter)
        java.util.Objects.requireNonNull(
            configuration.getEntry(
                COMPONENT,
                "serverExporter",
                Exporter.class,
                Exporters.jeri(settings, DEADLINE_MILLIS),
                settings));
  }

  private static final long DEADLINE_MILLIS =
      org.dfra.river.call.DeadlineILFactory.DEFAULT_DEADLINE.toMillis();

  /** Undoes what was done, last first; adds what fails in it to {@code reason}. */
  private void close(Throwable reason) {
    while (!undo.isEmpty()) {
      try {
        undo.pop().close();
      } catch (Exception e) {
        reason.addSuppressed(e);
      }
    }
  }

  /** The driver, by the module's interface. */
  protected final M module() {
    return module;
  }

  @Override
  public final Object getProxy() {
    return remote;
  }

  @Override
  public final Identification identification() throws RemoteException {
    return module.identification();
  }

  @Override
  public final Readiness readiness() throws RemoteException {
    return module.readiness();
  }

  @Override
  public final Readiness awaitReadiness(Duration patience) throws RemoteException {
    return module.awaitReadiness(patience.compareTo(LONGEST_WAIT) < 0 ? patience : LONGEST_WAIT);
  }

  @Override
  public final Lease use(long duration) throws LeaseDeniedException {
    return landlord.grant(duration);
  }

  @Override
  public final String toString() {
    return path + " (" + getClass().getSimpleName() + ")";
  }
}
