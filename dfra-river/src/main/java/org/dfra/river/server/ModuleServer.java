package org.dfra.river.server;

import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.Path;
import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.UUID;
import java.util.stream.Collectors;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationProvider;
import net.jini.config.EmptyConfiguration;
import net.jini.export.Exporter;
import net.jini.export.ProxyAccessor;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.directory.SelfDescription;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.state.StateStore;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.event.Subscription;
import org.dfra.lease.Holder;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.ModuleLease;
import org.dfra.module.History;
import org.dfra.module.Identification;
import org.dfra.module.LogLevel;
import org.dfra.module.Module;
import org.dfra.module.Parameter;
import org.dfra.module.Readiness;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.lease.ModuleLandlord;
import org.dfra.river.proxy.LocalModules;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.LeasedUse;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.server.Exporters.ServerSettings;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/**
 * Activatable server of a module: it makes the driver and serves it to the network.
 *
 * <p>Constructing is starting, as the activation system demands: the steps run in the constructor,
 * and if one fails, those before it are undone. {@link #close} undoes all of them.
 *
 * @param <M> the module's interface
 */
public abstract class ModuleServer<M extends Module>
    implements RemoteModule, ProxyAccessor, AutoCloseable {

  /** Component of the entries that a module's Jini configuration may have. */
  static final String COMPONENT = "org.dfra.river.server";

  private static final long DEADLINE_MILLIS = DeadlineILFactory.DEFAULT_DEADLINE.toMillis();

  private final String path;
  private final M module;
  private final Remote remote;
  private final ModuleLandlord landlord;
  private final RemoteListeners listeners;
  private final ModuleAdministration administration;
  private final Deque<AutoCloseable> undo = new ArrayDeque<>(); // guarded by itself

  /**
   * Step 1: the activation system constructs the server; the other five follow.
   *
   * @param kind the module's interface
   * @param id the server's activation ID; null where no activation system makes it: then its proxy
   *     does not bring it back
   * @param data the server's {@link ModuleActivation}
   * @throws ConfigurationException if what the module's description names cannot be used
   * @throws Exception if the data cannot be read
   */
  protected ModuleServer(
      Class<M> kind, @Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    ModuleActivation activation = data.get();
    ModuleDescription description = activation.module();
    this.path = description.path();
    try {
      // Step 2: the properties.
      Configuration configuration = configuration(description);

      // Step 3: the driver.
      ModuleImpl driver =
          driver(context(activation, ModuleLandlord.terms(configuration)), description, kind);
      undo.push(driver);
      this.module = kind.cast(driver);
      driver.start();
      LocalModules.enter(activation.id(), driver);
      undo.push(() -> LocalModules.leave(activation.id(), driver));

      // Step 4: the proxy, and before it the landlord, since clients may come at once.
      Exporter exporter = exporter(configuration, new ServerSettings(id, activation.host()));
      this.landlord =
          new ModuleLandlord(
              path, driver.leases(), Exporters.jeri(activation.host(), DEADLINE_MILLIS));
      this.listeners = new RemoteListeners(driver, landlord);
      landlord.start();
      undo.push(landlord);
      this.remote = exporter.export(this);
      undo.push(() -> exporter.unexport(true));
      ModuleProxy<?> proxy =
          proxy(description, kind, (RemoteModule) remote, activation.id(), driver.identification());

      // Step 5: discovery and join.
      ModulePresence presence =
          new ModulePresence(
              new SelfDescription(
                  driver,
                  activation.host(),
                  activation.created(),
                  Instant.now(),
                  driver.leases()::clients),
              proxy,
              activation,
              configuration);
      undo.push(presence);
      this.administration =
          new ModuleAdministration(
              presence, driver.leases(), activation.host(), id, exporter, this::close);
      undo.push(administration);
      if (id != null) { // elsewhere the process is not this module's
        undo.push(EndOfProcess.closes(path, this::close));
      }
    } catch (Exception e) { // a driver's, a configuration's or River's; all name the place
      ConfigurationException fault = placed(description, e);
      undoAll(fault);
      throw fault;
    } catch (Error e) {
      undoAll(e);
      throw e;
    }
  }

  private static Configuration configuration(ModuleDescription description)
      throws net.jini.config.ConfigurationException {
    return description.configuration() == null
        ? EmptyConfiguration.INSTANCE
        : ConfigurationProvider.getInstance(new String[] {description.configuration()});
  }

  private static ModuleContext context(ModuleActivation activation, LeaseTerms terms) {
    ModuleDescription description = activation.module();
    @Nullable String folder = activation.state();
    return new ModuleContext(
        description.robot(),
        description.name(),
        description.parameters(),
        InstantSource.system(),
        folder == null ? StateStore.inMemory() : StateStore.in(Path.of(folder)),
        terms,
        Scheduler.system());
  }

  private static ModuleImpl driver(
      ModuleContext context, ModuleDescription description, Class<?> kind) {
    Class<?> type = load(description, "driver", description.driverClass());
    if (!ModuleImpl.class.isAssignableFrom(type) || !kind.isAssignableFrom(type)) {
      throw fault(
          description,
          "driver " + type.getName() + " is no ModuleImpl that implements " + kind.getName(),
          null);
    }
    return (ModuleImpl)
        construct(description, "driver", type, new Class<?>[] {ModuleContext.class}, context);
  }

  private static ModuleProxy<?> proxy(
      ModuleDescription description,
      Class<?> kind,
      RemoteModule server,
      UUID id,
      Identification identification) {
    Class<?> type = load(description, "proxy", description.proxyClass());
    if (!ModuleProxy.class.isAssignableFrom(type) || !kind.isAssignableFrom(type)) {
      throw fault(
          description,
          "proxy " + type.getName() + " is no ModuleProxy that implements " + kind.getName(),
          null);
    }
    return (ModuleProxy<?>)
        construct(
            description,
            "proxy",
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
              + " is not on the group's class path; add its jar or mend the name",
          e);
    } catch (LinkageError e) {
      throw fault(
          description,
          what + " class " + name + " cannot be loaded (" + e + "); add the jar that it needs",
          e);
    }
  }

  private static Object construct(
      ModuleDescription description,
      String what,
      Class<?> type,
      Class<?>[] parameters,
      Object... arguments) {
    try {
      return type.getConstructor(parameters).newInstance(arguments);
    } catch (NoSuchMethodException e) {
      throw fault(
          description,
          what
              + " "
              + type.getName()
              + " has no public constructor "
              + Arrays.stream(parameters)
                  .map(Class::getSimpleName)
                  .collect(Collectors.joining(", ", "(", ")")),
          e);
    } catch (InvocationTargetException e) {
      if (e.getCause() instanceof ConfigurationException cause) {
        throw cause;
      }
      throw fault(description, what + " " + type.getName() + " cannot be made: " + e.getCause(), e);
    } catch (ReflectiveOperationException e) {
      throw fault(description, what + " " + type.getName() + " cannot be made: " + e, e);
    }
  }

  private static Exporter exporter(Configuration configuration, ServerSettings settings)
      throws net.jini.config.ConfigurationException {
    @Nullable Exporter exporter =
        (Exporter)
            configuration.getEntry(
                COMPONENT,
                "serverExporter",
                Exporter.class,
                Exporters.jeri(settings, DEADLINE_MILLIS),
                settings);
    if (exporter == null) {
      throw new net.jini.config.ConfigurationException(
          COMPONENT + ".serverExporter is null; leave it out to have the usual one");
    }
    return exporter;
  }

  /** A failed step as a sentence that names the place where the module is described. */
  private static ConfigurationException placed(ModuleDescription description, Exception failure) {
    if (failure instanceof ConfigurationException known) {
      // What is not written at all has no place of its own.
      return String.valueOf(known.getMessage()).startsWith(description.path() + ":")
          ? new ConfigurationException(description.place() + ": " + known.getMessage(), known)
          : known;
    } else if (failure instanceof net.jini.config.ConfigurationException) {
      String message = String.valueOf(failure.getMessage());
      String file = String.valueOf(description.configuration());
      return fault(
          description,
          "its Jini configuration "
              + (message.contains(file) ? "" : file + " ")
              + "cannot be used: "
              + message,
          failure);
    } else if (failure instanceof IOException && !(failure instanceof RemoteException)) {
      return fault(description, String.valueOf(failure.getMessage()), failure);
    }
    return fault(description, "it cannot be served: " + failure, failure);
  }

  private static ConfigurationException fault(
      ModuleDescription description, String what, @Nullable Throwable cause) {
    String message = description.place() + ": module " + description.path() + ": " + what;
    return cause == null
        ? new ConfigurationException(message)
        : new ConfigurationException(message, cause);
  }

  /** Undoes what was done, last first; adds what fails in it to {@code reason}. */
  private void undoAll(Throwable reason) {
    synchronized (undo) {
      while (!undo.isEmpty()) {
        try {
          undo.pop().close();
        } catch (Exception e) { // as AutoCloseable declares it; the rest must be undone
          reason.addSuppressed(e);
        }
      }
    }
  }

  /**
   * Ends the service: leases, lookup, export and driver, in this order. Does nothing when already
   * ended.
   *
   * @throws IllegalStateException if a part of it could not be ended; the others were
   */
  @Override
  public final void close() {
    IllegalStateException failure = new IllegalStateException(path + " did not end cleanly");
    undoAll(failure);
    if (failure.getSuppressed().length > 0) {
      throw failure;
    }
  }

  /** The module's path, {@code robot/name}. */
  protected final String path() {
    return path;
  }

  /** The driver, by the module's interface. */
  protected final M module() {
    return module;
  }

  @Override
  public final Object getProxy() {
    return remote;
  }

  /** The module's {@link org.dfra.river.remote.ModuleAdmin}. */
  @Override
  public final Object getAdmin() throws RemoteException {
    return administration.stub();
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
  public final Subscription subscribe(ModuleListener listener, DeliveryPolicy policy) {
    return listeners.add(listener, policy);
  }

  @Override
  public final ModuleLease use(Duration duration) throws LeaseRefusedException {
    return new LeasedUse(landlord.grant(duration.toMillis(), Holder.CLIENT, () -> {}));
  }

  @Override
  public final History history() throws RemoteException {
    return module.history();
  }

  @Override
  public final LogLevel logLevel() throws RemoteException {
    return module.logLevel();
  }

  @Override
  public final void setLogLevel(LogLevel level) throws RemoteException {
    module.setLogLevel(level);
  }

  @Override
  public final List<Parameter> parameters() throws RemoteException {
    return module.parameters();
  }

  @Override
  public final void setParameter(String name, String text) throws RemoteException {
    module.setParameter(name, text);
  }

  @Override
  public final String toString() {
    return path + " (" + getClass().getSimpleName() + ")";
  }
}
