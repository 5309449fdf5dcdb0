package org.dfra.river.phoenix;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.net.BindException;
import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.ActivationMonitor;
import java.rmi.activation.ActivationSystem;
import java.rmi.activation.Activator;
import java.rmi.activation.UnknownGroupException;
import java.rmi.activation.UnknownObjectException;
import java.rmi.registry.LocateRegistry;
import java.rmi.registry.Registry;
import java.rmi.server.ExportException;
import java.security.PrivilegedActionException;
import java.security.PrivilegedExceptionAction;
import java.time.Duration;
import java.time.InstantSource;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import javax.security.auth.Subject;
import javax.security.auth.login.LoginException;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationException;
import net.jini.config.ConfigurationProvider;
import net.jini.export.Exporter;
import org.dfra.river.call.PeerAddress;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.loading.TrustedCode;
import org.dfra.river.phoenix.access.LocalCallerGuard;
import org.dfra.river.phoenix.access.ReadOnlyRegistrySocketFactory;
import org.dfra.river.phoenix.host.UncaughtExceptionLogger;
import org.dfra.river.security.SecureProcess;
import org.dfra.river.security.budget.ProcessBudgets;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.slf4j.bridge.SLF4JBridgeHandler;

/**
 * The activation daemon's process: one per host. {@link #main} starts it. {@link
 * ActivationSystem#shutdown} or a signal ends it and its groups. If it is killed, its groups keep
 * running, and the next daemon adopts them.
 */
public final class Phoenix implements AutoCloseable {

  /** System property of a group from which phoenix forms its name in files and messages. */
  public static final String GROUP_NAME = "org.dfra.group";

  private static final Logger LOG = LoggerFactory.getLogger(Phoenix.class);

  /** Prefix of the log message with the reason why phoenix did not start. */
  public static final String CANNOT_START = "Phoenix cannot start: ";

  /** A process that inherited the port closes it within milliseconds, or when it gets to run. */
  private static final Duration INHERITED_PORT = Duration.ofSeconds(5);

  private static final Duration PORT_POLL = Duration.ofMillis(20);

  private static final String SYSTEM_NAME = "java.rmi.activation.ActivationSystem";

  private final PhoenixConfiguration configuration;
  private final PhoenixDaemon daemon;
  // Strong references: JERI keeps exported objects only weakly.
  private final ActivatorService activatorService;
  private final SystemService systemService;
  private final MonitorService monitorService;
  private final StopServiceImpl stopOrders;
  private final CountDownLatch closed = new CountDownLatch(1);
  private @Nullable Registry registry;

  @GuardedBy("this")
  private boolean closing;

  private Phoenix(PhoenixConfiguration configuration, InstantSource clock) throws IOException {
    this.configuration = configuration;
    this.daemon =
        new PhoenixDaemon(
            configuration,
            clock,
            Scheduler.system(),
            Journal.open(
                configuration.persistenceDirectory(),
                configuration.persistenceSnapshotThreshold()));
    GroupTable registered = daemon.groupTable();
    GroupRegistry registry = daemon.groupRegistry();
    LocalCallerGuard access = new LocalCallerGuard();
    this.activatorService = new ActivatorService(registered);
    this.systemService = new SystemService(registered, registry, configuration, access);
    this.monitorService = new MonitorService(registered, registry, access);
    this.stopOrders = new StopServiceImpl(registered);
  }

  /**
   * Starts phoenix and serves until it is shut down.
   *
   * @param args the Jini configuration: a file and overrides, as for any River service
   */
  public static void main(String[] args) throws InterruptedException {
    SerialFilters.install();
    SLF4JBridgeHandler.removeHandlersForRootLogger();
    SLF4JBridgeHandler.install();
    UncaughtExceptionLogger.install();
    try {
      TrustedCode.install();
      SecureProcess.Installed unused = SecureProcess.installFromProperty();
      Phoenix phoenix = start(ConfigurationProvider.getInstance(args));
      SecureProcess.startAudit("phoenix"); // no other daemon has the journal now
      Runtime.getRuntime().addShutdownHook(new Thread(phoenix::close, "phoenix-end"));
      phoenix.closed.await();
      Runtime.getRuntime().exit(0);
    } catch (ConfigurationException | IOException | LoginException | IllegalStateException e) {
      LOG.error(CANNOT_START + "{}", e.getMessage());
      LOG.debug("Phoenix cannot start.", e);
      Runtime.getRuntime().exit(1);
    }
  }

  /**
   * Starts phoenix in this virtual machine.
   *
   * @throws IOException if its folder is open to other users, its journal cannot be used or a port
   *     is taken
   */
  public static Phoenix start(Configuration c)
      throws ConfigurationException, IOException, LoginException {
    // First, since a configuration may need the identities too, and would hide why they are
    // missing.
    SecretIdentities identities = SecretIdentities.in(PhoenixConfiguration.folder(c));
    PhoenixConfiguration configuration = PhoenixConfiguration.read(c, identities);
    if (configuration.loginContext() == null) {
      return open(configuration);
    }
    configuration.loginContext().login();
    try {
      return asSubject(configuration.loginContext().getSubject(), () -> open(configuration));
    } catch (PrivilegedActionException e) {
      throw e.getException() instanceof IOException cause ? cause : new IOException(e);
    }
  }

  @SuppressWarnings("removal") // its successor came with Java 18; the daemon supports 17 too
  private static <T> T asSubject(Subject subject, PrivilegedExceptionAction<T> action)
      throws PrivilegedActionException {
    return Subject.doAs(subject, action);
  }

  private static Phoenix open(PhoenixConfiguration configuration) throws IOException {
    Phoenix phoenix = new Phoenix(configuration, InstantSource.system());
    try {
      phoenix.serve();
      return phoenix;
    } catch (IOException | RuntimeException e) {
      phoenix.abandon();
      throw e;
    }
  }

  private void serve() throws IOException {
    daemon.recover();
    // The registry's port first, so that a daemon that answers has started completely.
    @Nullable Registry open =
        configuration.registryPort() < 0 ? null : readOnlyRegistry(configuration.registryPort());
    registry = open;
    ActivationMonitor monitor =
        (ActivationMonitor) export(configuration.monitorExporter(), monitorService);
    ActivationSystem system =
        (ActivationSystem) export(configuration.systemExporter(), systemService);
    // Before the activator: a group that is started must receive the right address.
    daemon.updateAddress(system);
    daemon
        .groupTable()
        .exported((Activator) export(configuration.activatorExporter(), activatorService));
    Remote stops = export(configuration.stopExporter(), stopOrders); // its identity is known
    exportBudgets(PeerAddress.of(stops));
    // Last, since callers of the system wait for it: groups and activator must be ready by then.
    systemService.exported(system, monitor, this::closeSoon);
    if (open != null) {
      open.rebind(SYSTEM_NAME, system);
    }
    daemon.scheduleRestarts();
    LOG.info("Phoenix is ready: {} groups.", daemon.groupTable().groups().size());
  }

  /** At phoenix's port, which its users know. */
  private static void exportBudgets(@Nullable PeerAddress here) throws ExportException {
    Optional<ProcessBudgets> budgets = SecureProcess.budgets();
    if (here != null && budgets.isPresent()) {
      budgets.get().export(here.host(), here.port());
    }
  }

  /** Undoes a failed start; the groups that were found running continue to run. */
  private void abandon() {
    unexport(configuration.activatorExporter());
    unexport(configuration.stopExporter());
    unexport(configuration.systemExporter());
    unexport(configuration.monitorExporter());
    closeRegistry();
    daemon.stopKeepingProcesses();
  }

  /**
   * Exports a service, once its port is free. A phoenix that was killed while it started a process
   * may have left it the port: the JDK closes the descriptors that a new process inherits only when
   * that process runs.
   */
  private static Remote export(Exporter exporter, Remote service) throws ExportException {
    long end = System.nanoTime() + INHERITED_PORT.toNanos();
    boolean isReported = false;
    while (true) {
      try {
        return exporter.export(service);
      } catch (ExportException e) {
        Throwable cause = innermost(e);
        if (!(cause instanceof BindException) || System.nanoTime() - end >= 0) {
          // Without the cause: an export exception's message repeats its cause's, over several
          // lines.
          throw new ExportException(
              "Phoenix's port cannot be opened ("
                  + cause.getMessage()
                  + "); another phoenix may be running on this host: stop it, or give this one"
                  + " another port");
        }
        if (!isReported) {
          LOG.info(
              "Phoenix's port is taken ({}); trying again for {} s.",
              cause.getMessage(),
              INHERITED_PORT.toSeconds());
          isReported = true;
        }
        LockSupport.parkNanos(PORT_POLL.toNanos()); // no event reports a free port
      }
    }
  }

  /**
   * Creates the RMI registry in which programs that know only {@code java.rmi.activation} find the
   * system. Any user can read it, and it reveals the system's secret identity. So it exists only if
   * configured.
   *
   * <p>Its filter refuses every class: a lookup sends a string, which is none, and a bind is
   * refused. Its sockets refuse all other changes. The binding here, in the registry's own virtual
   * machine, passes neither.
   */
  private static Registry readOnlyRegistry(int port) throws IOException {
    System.setProperty("sun.rmi.registry.registryFilter", "!*");
    try {
      return LocateRegistry.createRegistry(port, null, new ReadOnlyRegistrySocketFactory());
    } catch (ExportException e) {
      throw new IOException(
          "the registry's port "
              + port
              + " cannot be opened ("
              + innermost(e).getMessage()
              + "); give it another one, or none with -1",
          e);
    }
  }

  private static Throwable innermost(Throwable e) {
    Throwable at = e;
    while (at.getCause() != null) {
      at = at.getCause();
    }
    return at;
  }

  private void closeSoon() {
    if (!daemon.isRunning()) {
      return; // already requested
    }
    // On its own thread, so that the caller still receives the answer.
    Thread end = new Thread(this::close, "phoenix-shutdown");
    end.start();
  }

  /** Refuses new work, ends every group's process, closes the journal. Idempotent. */
  @Override
  public void close() {
    synchronized (this) {
      if (closing) {
        awaitClosed();
        return;
      }
      closing = true;
    }
    LOG.info("Phoenix ends, and its groups with it.");
    unexport(configuration.activatorExporter());
    daemon.stop(configuration.unexportTimeout());
    unexport(configuration.stopExporter()); // slow shutdowns can be stopped meanwhile
    unexport(configuration.systemExporter());
    unexport(configuration.monitorExporter());
    closeRegistry();
    closed.countDown();
  }

  private void closeRegistry() {
    if (registry != null) {
      try {
        java.rmi.server.UnicastRemoteObject.unexportObject(registry, true);
      } catch (java.rmi.NoSuchObjectException e) {
        LOG.debug("The registry had ended before.", e);
      }
    }
  }

  private void awaitClosed() {
    try {
      closed.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Waits for running calls up to the timeout, then forces. */
  private void unexport(Exporter exporter) {
    Duration patience = Duration.ofSeconds(1);
    long end = System.nanoTime() + patience.toNanos();
    try {
      while (!exporter.unexport(false) && System.nanoTime() - end < 0) {
        LockSupport.parkNanos(
            this, TimeUnit.MILLISECONDS.toNanos(configuration.unexportWait().toMillis()));
      }
      exporter.unexport(true);
    } catch (IllegalStateException e) {
      LOG.debug("Never exported.", e);
    }
  }

  /** Serves proxies of inactive objects, from any computer. */
  private static final class ActivatorService implements Activator {

    private final GroupTable registered;

    ActivatorService(GroupTable registered) {
      this.registered = registered;
    }

    @Override
    public MarshalledObject<? extends Remote> activate(ActivationID id, boolean force)
        throws ActivationException, RemoteException {
      return registered.object(id).activate(id, force);
    }
  }

  /** Receives the groups' reports. Calls from other computers are refused. */
  static final class MonitorService implements ActivationMonitor {

    private final GroupTable registered;
    private final GroupRegistry registry;
    private final LocalCallerGuard access;

    MonitorService(GroupTable registered, GroupRegistry registry, LocalCallerGuard access) {
      this.registered = registered;
      this.registry = registry;
      this.access = access;
    }

    @Override
    public void inactiveObject(ActivationID id) throws UnknownObjectException, RemoteException {
      access.check("inactiveObject");
      registry.inactive(GroupTable.uid(id));
    }

    @Override
    public void activeObject(ActivationID id, MarshalledObject<? extends Remote> proxy)
        throws UnknownObjectException, RemoteException {
      access.check("activeObject");
      registered.object(id).active(proxy);
    }

    @Override
    public void inactiveGroup(ActivationGroupID id, long incarnation)
        throws UnknownGroupException, RemoteException {
      access.check("inactiveGroup");
      registered.group(id).onLeaving(incarnation);
    }
  }
}
