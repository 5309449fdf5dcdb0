package org.dfra.river.server;

import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import java.rmi.server.ExportException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.UUID;
import net.jini.config.Configuration;
import net.jini.core.lease.Lease;
import net.jini.export.Exporter;
import net.jini.export.ProxyAccessor;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.directory.SelfDescription;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.robot.ResourceCloser;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.event.Subscription;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.LeaseRole;
import org.dfra.lease.ModuleLease;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Identification;
import org.dfra.module.LogLevel;
import org.dfra.module.Module;
import org.dfra.module.ModuleHistory;
import org.dfra.module.Parameter;
import org.dfra.river.access.GuardedObject;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.lease.ModuleLandlord;
import org.dfra.river.lease.ProcessLandlord;
import org.dfra.river.phoenix.ReadinessSource;
import org.dfra.river.phoenix.StartedObject;
import org.dfra.river.proxy.LocalModuleRegistry;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.GrantedModuleLease;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.security.SecureProcess;
import org.dfra.river.security.news.NewsExchange;
import org.dfra.river.server.Exporters.ServerSettings;
import org.jspecify.annotations.Nullable;

/**
 * Activatable server of a module: it creates the driver and exports it to the network.
 *
 * <p>The constructor creates the driver; no other thread knows the server yet. {@link #start}
 * starts the module and exports it. A group calls both. If one step fails, it undoes the steps
 * before. {@link #close} undoes all of them.
 *
 * @param <M> the module's interface
 */
public abstract class ModuleServer<M extends Module>
    implements RemoteModule,
        ProxyAccessor,
        ReadinessSource,
        StartedObject,
        GuardedObject,
        AutoCloseable {

  /** Component of the entries that a module's Jini configuration may have. */
  static final String COMPONENT = "org.dfra.river.server";

  static final long DEADLINE_MILLIS = DeadlineILFactory.DEFAULT_DEADLINE.toMillis();

  private final ModuleActivation activation;
  private final @Nullable ActivationID activationId;
  private final ModulePartFactory parts;
  private final Configuration configuration;
  private final Class<M> kind;
  private final M module;
  private final ModuleImpl driver;
  private final DriverShutdown driverEnd;
  private final Exporter exporter;
  private final ModuleLandlord landlord;
  private final RemoteListenerRegistry listeners;
  private final Deque<AutoCloseable> undo = new ArrayDeque<>(); // guarded by itself
  private volatile @Nullable Remote remote; // once it is exported
  private volatile @Nullable ModuleAdministration administration; // once it is registered

  /**
   * Step 1: the activation system constructs the server; the other four follow.
   *
   * @param kind the module's interface
   * @param id the server's activation ID; null if no activation system creates it: then its proxy
   *     does not reactivate it
   * @param data the server's {@link ModuleActivation}
   * @throws ConfigurationException if a part that the module's description names cannot be used
   * @throws Exception if the data cannot be read
   */
  protected ModuleServer(
      Class<M> kind, @Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    this(kind, ModuleImpl.class, id, data);
  }

  /**
   * As the other constructor, for a driver with a more specific base class than {@link ModuleImpl}.
   * Another driver is refused before the export.
   *
   * @param base what the driver must extend
   */
  protected ModuleServer(
      Class<M> kind,
      Class<? extends ModuleImpl> base,
      @Nullable ActivationID id,
      MarshalledObject<ModuleActivation> data)
      throws Exception {
    this.kind = kind;
    this.activation = data.get();
    this.activationId = id;
    this.parts = new ModulePartFactory(activation);
    ResourceCloser failed = new ResourceCloser(activation.module().path());
    try {
      // Step 2: the properties.
      this.configuration = parts.configuration();
      this.exporter =
          ModulePartFactory.exporter(configuration, new ServerSettings(id, activation.host()));

      // Step 3: the driver, which may search for other modules.
      this.driver = parts.driver(ModuleLandlord.terms(configuration), kind, base);
    } catch (Exception e) { // of a driver or a configuration; all name the location
      ConfigurationException fault = parts.withLocation(e);
      failed.close(parts.directorySupplier());
      failed.addSuppressedTo(fault);
      throw fault;
    } catch (Error e) {
      failed.close(parts.directorySupplier());
      failed.addSuppressedTo(e);
      throw e;
    }
    this.module = kind.cast(driver);
    this.driverEnd = new DriverShutdown(driver);
    this.landlord =
        new ModuleLandlord(
            path(),
            driver.leases(),
            ProcessLandlord.exporterAt(
                activation.host(), () -> Exporters.jeri(activation.host(), DEADLINE_MILLIS)),
            activation.host());
    this.listeners = new RemoteListenerRegistry(driver, landlord, activation.host());
    undo.push(parts.directorySupplier());
    undo.push(driverEnd);
  }

  /**
   * Starts a server that no group starts, as in one virtual machine.
   *
   * @return the same server
   * @throws ConfigurationException as {@link #start}
   */
  public static <S extends ModuleServer<?>> S started(S server) {
    server.start();
    return server;
  }

  /**
   * Starts the driver, exports the server and registers it. Called once, before any other method.
   *
   * @throws ConfigurationException if a part that the module's description names cannot be used, or
   *     the server cannot be exported; then it is closed
   */
  @Override
  public final void start() {
    try {
      driver.start();
      LocalModuleRegistry.register(id(), driver);
      onUndo(() -> LocalModuleRegistry.unregister(id(), driver));

      // Step 4: the proxy, and before it the landlord, since clients may call immediately.
      landlord.start();
      onUndo(landlord);
      onUndo(beforeExport());
      Remote exported = exporter.export(this);
      remote = exported;
      exportNews();
      onUndo(() -> exporter.unexport(true));
      ModuleProxy<?> proxy =
          parts.proxy(kind, (RemoteModule) exported, id(), driver.identification());

      // Step 5: discovery and join.
      ModuleRegistration presence =
          new ModuleRegistration(
              new SelfDescription(
                  driver,
                  activation.host(),
                  activation.created(),
                  Instant.now(),
                  driver.leases()::clients),
              proxy,
              activation,
              configuration);
      onUndo(presence);
      ModuleAdministration admin =
          new ModuleAdministration(
              presence, driver, activation.host(), activationId, exporter, this, driverEnd);
      administration = admin;
      onUndo(admin);
      if (activationId != null) { // otherwise the process is not the module's
        onUndo(ModuleShutdownHook.register(this));
      }
    } catch (Exception e) { // of a driver, a configuration or River; all name the location
      ConfigurationException fault = parts.withLocation(e);
      undoAll().addSuppressedTo(fault);
      throw fault;
    } catch (Error e) {
      undoAll().addSuppressedTo(e);
      throw e;
    }
  }

  /**
   * Called when the driver has started, before clients can call.
   *
   * @return is closed with the server, after its export has ended
   */
  protected AutoCloseable beforeExport() {
    return () -> {};
  }

  private void onUndo(AutoCloseable step) {
    synchronized (undo) {
      undo.push(step);
    }
  }

  /** Undoes the steps in reverse order, but first closes a driver that moves the robot. */
  private ResourceCloser undoAll() {
    ResourceCloser ending = new ResourceCloser(path());
    halt();
    synchronized (undo) {
      while (!undo.isEmpty()) {
        ending.close(undo.pop());
      }
    }
    return ending;
  }

  /**
   * Closes the driver of a module that moves the robot: it stops the device and executes no further
   * command. Does nothing for any other module, or if the shutdown has started. To shut down
   * several modules, halt all of them before closing the first. {@link #close} reports failures.
   */
  public final void halt() {
    driverEnd.halt();
  }

  /**
   * Ends the service: leases, registrations, export and driver, in this order. A driver that moves
   * the robot is closed first, see {@link #halt}: lookup services that do not answer must not delay
   * the stop of the wheels. Takes about 1 s if lookup services do not answer. Idempotent. If
   * another thread is closing the driver, this does not wait for it, so that a blocked driver does
   * not keep its module registered.
   *
   * @throws IllegalStateException if a part could not be closed; the others were
   */
  @Override
  public final void close() {
    undoAll().throwIfFailed(IllegalStateException::new);
  }

  /** The module's path, {@code robot/name}. */
  protected final String path() {
    return activation.module().path();
  }

  /** The module's identity, its service ID in every lookup service. */
  protected final UUID id() {
    return activation.id();
  }

  /** The driver, by the module's interface. */
  protected final M module() {
    return module;
  }

  /** Grants a lease to the client of the current call; see {@link ModuleLandlord#grant}. */
  protected final Lease grant(
      Duration duration, LeaseRole holder, Runnable onExpired, Runnable onCancelled)
      throws LeaseRefusedException {
    return landlord.grant(duration.toMillis(), holder, onExpired, onCancelled);
  }

  /** The address of the current call's client, for people. */
  protected static String clientName() {
    @Nullable String host = ModuleLandlord.clientHost();
    return host == null ? "a client elsewhere" : "a client at " + host;
  }

  @Override
  public final Object getProxy() {
    return Objects.requireNonNull(remote, "the server is not started");
  }

  /** At the same port, for all modules of the process. */
  private void exportNews() throws ExportException {
    Optional<NewsExchange> news = SecureProcess.news();
    if (news.isPresent()) {
      news.get().export(activation.host());
    }
  }

  /** The module's {@link org.dfra.river.remote.ModuleAdmin}. */
  @Override
  public final Object getAdmin() throws RemoteException {
    return Objects.requireNonNull(administration, "the module is being started").stub();
  }

  @Override
  public final String guardedName() {
    return activation.module().name();
  }

  @Override
  public final Identification identification() throws RemoteException {
    return module.identification();
  }

  @Override
  public final Readiness readiness() throws RemoteException {
    return module.readiness();
  }

  /** {@inheritDoc} For phoenix, which restarts a stable module at once. */
  @Override
  public final boolean isReady() {
    return driver.readiness().serves(); // READY, or ACTIVE if a client called first
  }

  @Override
  public final Readiness awaitReadiness(Duration patience) throws RemoteException {
    return module.awaitReadiness(patience.compareTo(MAX_CALL_WAIT) < 0 ? patience : MAX_CALL_WAIT);
  }

  @Override
  public final Subscription subscribe(ModuleListener listener, DeliveryPolicy policy) {
    return listeners.add(listener, policy);
  }

  @Override
  public final ModuleLease acquireLease(Duration duration) throws LeaseRefusedException {
    return new GrantedModuleLease(grant(duration, LeaseRole.CLIENT, () -> {}, () -> {}));
  }

  @Override
  public final ModuleHistory history() throws RemoteException {
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
    return path() + " (" + getClass().getSimpleName() + ")";
  }
}
