package org.dfra.river.bootstrap;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import com.sun.jini.admin.DestroyAdmin;
import com.sun.jini.start.LifeCycle;
import com.sun.jini.start.ServiceProxyAccessor;
import java.io.IOException;
import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.Socket;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import net.jini.config.Configuration;
import net.jini.core.entry.Entry;
import net.jini.core.lookup.ServiceRegistrar;
import org.dfra.core.host.FreePorts;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.call.JeriExporters;
import org.dfra.river.lookup.SuppliedConfiguration;
import org.dfra.river.registrar.DiscoveryResponseSocketFactory;
import org.dfra.river.registrar.DiscoveryServerSocketFactory;
import org.dfra.river.registrar.RegistrarILFactory;
import org.dfra.river.registrar.RegistrarTaskManager;
import org.dfra.river.registrar.RegistrationPolicy;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A lookup service in this virtual machine: stock reggie without persistent state, at one address
 * and without multicast. For robots and tests without an activation system.
 *
 * <p>{@link #start} starts it and {@link #close} ends it; both do nothing the second time. After
 * {@link #close} it can be started again: the result is another lookup service at the same port,
 * without registrations.
 */
public final class EmbeddedRegistrar implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(EmbeddedRegistrar.class);

  private static final String CLASS = "com.sun.jini.reggie.TransientRegistrarImpl";
  private static final String COMPONENT = "com.sun.jini.reggie.";
  private static final Duration STOP_TIMEOUT = Duration.ofSeconds(10);
  private static final long UNEXPORT_MILLIS = 1_000;
  private static final int WAKE_INTERVAL_MILLIS = 100;

  private record Running(Object reggie, ServiceRegistrar registrar, int port, CountDownLatch end) {}

  private final String host;
  private final RegistrationPolicy policy;
  private final Map<String, Supplier<?>> entries;

  // 0 before the first start, if none was named
  @GuardedBy("this")
  private int port;

  @GuardedBy("this")
  private @Nullable Running running;

  /**
   * Creates a registrar that belongs to no robot.
   *
   * @param host address of this machine, which its proxy carries
   * @param port TCP port of unicast discovery; 0 for a free one
   * @param groups discovery groups that it is a member of
   * @param maxLease the longest lease that it grants: a service that stops renewing is removed
   *     after it
   * @param extraEntries entries of its Jini configuration, by their names in reggie's component,
   *     which override the usual ones
   */
  public EmbeddedRegistrar(
      String host,
      int port,
      List<String> groups,
      Duration maxLease,
      Map<String, Supplier<?>> extraEntries) {
    this(host, port, groups, maxLease, RegistrationPolicy.NO_ROBOT, extraEntries);
  }

  /**
   * @param host address of this machine, which its proxy carries
   * @param port TCP port of unicast discovery; 0 for a free one
   * @param groups discovery groups that it is a member of
   * @param maxLease the longest lease that it grants: a service that stops renewing is removed
   *     after it
   * @param policy the robot that owns it, and its registration rules
   * @param extraEntries entries of its Jini configuration, by their names in reggie's component,
   *     which override the usual ones
   */
  public EmbeddedRegistrar(
      String host,
      int port,
      List<String> groups,
      Duration maxLease,
      RegistrationPolicy policy,
      Map<String, Supplier<?>> extraEntries) {
    this.host = host;
    this.port = port;
    this.policy = policy;
    NetworkInterface[] none = {};
    this.entries =
        new HashMap<>(
            Map.<String, Supplier<?>>of(
                COMPONENT + "initialMemberGroups",
                () -> groups.toArray(String[]::new),
                COMPONENT + "serverSocketFactory",
                () -> new DiscoveryServerSocketFactory(host),
                COMPONENT + "unicastDiscoveryHost",
                () -> host,
                COMPONENT + "multicastInterfaces",
                () -> none,
                COMPONENT + "minMaxServiceLease",
                maxLease::toMillis,
                COMPONENT + "minMaxEventLease",
                maxLease::toMillis,
                COMPONENT + "unexportTimeout", // for calls that are still running when it ends
                () -> UNEXPORT_MILLIS,
                "net.jini.discovery.LookupDiscovery.multicastInterfaces",
                () -> none));
    extraEntries.forEach((name, entry) -> entries.put(COMPONENT + name, entry));
  }

  /** Entries that reggie shows as its own, such as a robot's persona; for the constructor. */
  static Map<String, Supplier<?>> withLookupAttributes(List<Entry> own) {
    return Map.of("initialLookupAttributes", () -> own.toArray(Entry[]::new));
  }

  /**
   * Starts it.
   *
   * @throws IOException if it cannot start; the message gives the reason
   */
  public synchronized EmbeddedRegistrar start() throws IOException {
    if (running == null) {
      if (port == 0) { // reggie itself would try the default port, which a robot here may need
        port = FreePorts.allocate();
      }
      CountDownLatch end = new CountDownLatch(1);
      Object reggie = reggie(end);
      ServiceRegistrar registrar =
          (ServiceRegistrar) ((ServiceProxyAccessor) reggie).getServiceProxy();
      running = new Running(reggie, registrar, port, end);
    }
    return this;
  }

  private RegistrarExporter exporter(EventListenerPreparer listeners) {
    return new RegistrarExporter(
        JeriExporters.keepingAlive(
            Endpoints.tcp(host, 0),
            new RegistrarILFactory(DeadlineILFactory.DEFAULT_DEADLINE, policy)),
        listeners);
  }

  /** Instantiates reggie by name: DFRA is compiled without reggie. */
  @GuardedBy("this")
  private Object reggie(CountDownLatch end) throws IOException {
    int wanted = port;
    EventListenerPreparer listeners = new EventListenerPreparer(host);
    Map<String, Supplier<?>> all = new HashMap<>();
    all.put(COMPONENT + "serverExporter", () -> exporter(listeners));
    all.put(COMPONENT + "listenerPreparer", () -> listeners);
    all.put(COMPONENT + "socketFactory", DiscoveryResponseSocketFactory::new);
    all.put(COMPONENT + "taskManager", RegistrarTaskManager::new);
    all.putAll(entries);
    all.put(COMPONENT + "initialUnicastDiscoveryPort", () -> wanted);
    LifeCycle life =
        ended -> {
          end.countDown();
          return true;
        };
    try {
      Constructor<?> constructor =
          Class.forName(CLASS).getDeclaredConstructor(Configuration.class, LifeCycle.class);
      constructor.setAccessible(true);
      return constructor.newInstance(new SuppliedConfiguration(all), life);
    } catch (InvocationTargetException e) {
      throw new IOException(
          "the lookup service at " + host + " did not start: " + e.getCause(), e.getCause());
    } catch (ReflectiveOperationException e) {
      throw new IOException(
          "there is no usable reggie on the class path (" + e + "); add its jar", e);
    }
  }

  /**
   * The lookup service.
   *
   * @throws IllegalStateException if it does not run
   */
  public ServiceRegistrar registrar() {
    return running().registrar();
  }

  /** The lookup service; empty if it does not run. Another thread may end it at any time. */
  public synchronized Optional<ServiceRegistrar> registrarIfRunning() {
    return Optional.ofNullable(running).map(Running::registrar);
  }

  /** Its TCP port for unicast discovery. */
  public int port() {
    return running().port();
  }

  /** The locator for modules and clients: {@code jini://host:port}. */
  public String locator() {
    return "jini://" + host + ":" + port();
  }

  private synchronized Running running() {
    Running now = running;
    if (now == null) {
      throw new IllegalStateException("the lookup service at " + host + " does not run; start it");
    }
    return now;
  }

  /**
   * Ends it and waits until it has ended.
   *
   * @throws IOException if it does not end
   */
  @Override
  public synchronized void close() throws IOException {
    Running ending = running;
    running = null;
    if (ending == null) {
      return;
    }
    ((DestroyAdmin) ending.reggie()).destroy();
    try {
      if (!awaitEnd(ending)) {
        throw new IOException(
            "the lookup service at "
                + host
                + ":"
                + ending.port()
                + " did not end within "
                + STOP_TIMEOUT.toSeconds()
                + " s");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // it ends anyway
    }
  }

  /**
   * Reggie wakes its accept thread once, by a connection to this machine's own name. If that name
   * leads to another address than the one reggie listens at, this class must wake the thread.
   */
  private boolean awaitEnd(Running ending) throws InterruptedException {
    long began = System.nanoTime();
    while (!ending.end().await(WAKE_INTERVAL_MILLIS, TimeUnit.MILLISECONDS)) {
      if (System.nanoTime() - began > STOP_TIMEOUT.toNanos()) {
        return false;
      }
      wakeAcceptor(ending.port());
    }
    return true;
  }

  private void wakeAcceptor(int port) {
    try (Socket door = new Socket()) {
      door.connect(new InetSocketAddress(host, port), WAKE_INTERVAL_MILLIS);
    } catch (IOException e) {
      LOG.debug("The lookup service at {}:{} listens no more.", host, port, e);
    }
  }
}
