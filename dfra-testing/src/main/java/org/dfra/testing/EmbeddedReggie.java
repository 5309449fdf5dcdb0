package org.dfra.testing;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceRegistration;
import org.dfra.persona.Attributes;
import org.dfra.river.bootstrap.EmbeddedRegistrar;
import org.dfra.river.call.DeadlineExceededException;
import org.dfra.river.entry.Entries;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ExtensionContext.Namespace;
import org.junit.jupiter.api.extension.ParameterContext;
import org.junit.jupiter.api.extension.ParameterResolver;

/**
 * A lookup service in the test's own virtual machine: stock reggie, transient, on the loopback, at
 * a separate port, without multicast, so that concurrent tests never interfere.
 *
 * <p>As a JUnit extension it runs for the class or test that it is registered for:
 *
 * <pre>{@code
 * @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie(); // one for the class
 * @RegisterExtension final EmbeddedReggie reggie = new EmbeddedReggie();        // one for each test
 * @ExtendWith(EmbeddedReggie.class)                              // one for the class, as a parameter
 * }</pre>
 *
 * Parameters of type {@code EmbeddedReggie} and {@link JiniModuleDirectory} are supplied; a
 * directory is closed after the test. Without JUnit, call {@link #start} and {@link #close}.
 *
 * <p>Timings are those of a robot: a registration that is not renewed expires after {@link
 * #LEASE_MILLIS}.
 */
public final class EmbeddedReggie
    implements BeforeAllCallback,
        BeforeEachCallback,
        AfterEachCallback,
        ParameterResolver,
        AutoCloseable {

  /** Address of the lookup service. */
  public static final String HOST = "127.0.0.1";

  /** Lease duration of a registration, in milliseconds. */
  public static final long LEASE_MILLIS = 5_000;

  private static final Namespace NAMESPACE = Namespace.create(EmbeddedReggie.class);

  private final int wantedPort;
  private final Duration longestLease;

  @GuardedBy("this")
  private @Nullable EmbeddedRegistrar reggie;

  // empty before the first start
  @GuardedBy("this")
  private String group = "";

  /** A lookup service at a port that the system chooses. */
  public EmbeddedReggie() {
    this(0);
  }

  /**
   * @param port TCP port for unicast discovery; 0 lets the system choose
   */
  public EmbeddedReggie(int port) {
    this(port, Duration.ofMillis(LEASE_MILLIS));
  }

  /**
   * A lookup service with other timings than a robot's.
   *
   * @param port TCP port for unicast discovery; 0 lets the system choose
   * @param longestLease longest lease that it grants
   */
  public EmbeddedReggie(int port, Duration longestLease) {
    this.wantedPort = port;
    this.longestLease = longestLease;
  }

  /**
   * Starts it. Does nothing when already started.
   *
   * @throws IOException if its port is in use, or reggie does not start
   */
  public synchronized EmbeddedReggie start() throws IOException {
    if (reggie == null) {
      group = "test-" + UUID.randomUUID();
      reggie =
          new EmbeddedRegistrar(HOST, wantedPort, List.of(group), longestLease, Map.of()).start();
    }
    return this;
  }

  /** Stops it and waits until it has ended. Does nothing when not started. */
  @Override
  public synchronized void close() throws IOException {
    if (reggie != null) {
      EmbeddedRegistrar ending = reggie;
      reggie = null;
      ending.close();
    }
  }

  /**
   * The lookup service, for tests that call it directly.
   *
   * @throws IllegalStateException if it does not run; the other getters below throw the same
   */
  public ServiceRegistrar registrar() {
    return running().registrar();
  }

  /**
   * Registers a service, as a module registers itself. The caller must renew its lease. If the
   * answer is late, on a busy computer, it is registered once more: that replaces the first
   * registration.
   *
   * @param id its service ID
   * @param service its proxy
   * @param attributes its lookup attributes
   * @param leaseMillis the requested lease duration, in milliseconds; less may be granted
   * @throws RemoteException if the lookup service refuses it
   */
  public ServiceRegistration register(
      UUID id, Object service, List<? extends Attributes> attributes, long leaseMillis)
      throws RemoteException {
    ServiceItem item =
        new ServiceItem(
            new ServiceID(id.getMostSignificantBits(), id.getLeastSignificantBits()),
            service,
            Entries.toEntries(attributes));
    try {
      return registrar().register(item, leaseMillis);
    } catch (DeadlineExceededException e) {
      return registrar().register(item, leaseMillis);
    }
  }

  private synchronized EmbeddedRegistrar running() {
    if (reggie == null) {
      throw new IllegalStateException("the embedded reggie does not run; start it first");
    }
    return reggie;
  }

  /** Its locator for modules and clients: {@code jini://127.0.0.1:port}. */
  public String locator() {
    return "jini://" + HOST + ":" + port();
  }

  /** Its TCP port for unicast discovery. */
  public int port() {
    return running().port();
  }

  /** Its discovery group, of which no other lookup service is a member. */
  public synchronized String group() {
    running();
    return group;
  }

  /** A directory that finds modules in this lookup service only; the caller closes it. */
  public JiniModuleDirectory directory() throws IOException {
    return new JiniModuleDirectory(HOST, List.of(), List.of(locator()));
  }

  @Override
  public void beforeAll(ExtensionContext context) {
    startFor(context);
  }

  @Override
  public void beforeEach(ExtensionContext context) {
    startFor(context);
  }

  /** If one runs for the class already, it is used; otherwise this test gets its own. */
  private void startFor(ExtensionContext context) {
    context.getStore(NAMESPACE).getOrComputeIfAbsent(this, key -> new Run(started()));
  }

  private EmbeddedReggie started() {
    try {
      return start();
    } catch (IOException e) {
      throw new IllegalStateException("the embedded reggie did not start", e);
    }
  }

  /** Closes it together with the context that it was started for. */
  private record Run(EmbeddedReggie running) implements AutoCloseable {
    @Override
    public void close() throws IOException {
      running.close();
    }
  }

  @Override
  public boolean supportsParameter(ParameterContext parameter, ExtensionContext context) {
    Class<?> type = parameter.getParameter().getType();
    return type == EmbeddedReggie.class || type == JiniModuleDirectory.class;
  }

  @Override
  public Object resolveParameter(ParameterContext parameter, ExtensionContext context) {
    if (parameter.getParameter().getType() == EmbeddedReggie.class) {
      return started();
    }
    return context
        .getStore(NAMESPACE)
        .getOrComputeIfAbsent(
            JiniModuleDirectory.class, key -> startedDirectory(), JiniModuleDirectory.class);
  }

  private JiniModuleDirectory startedDirectory() {
    try {
      return started().directory();
    } catch (IOException e) {
      throw new IllegalStateException("no directory for the embedded reggie", e);
    }
  }

  /** Closes a supplied directory before its lookup service. */
  @Override
  public void afterEach(ExtensionContext context) {
    JiniModuleDirectory directory =
        context.getStore(NAMESPACE).remove(JiniModuleDirectory.class, JiniModuleDirectory.class);
    if (directory != null) {
      directory.close();
    }
  }
}
