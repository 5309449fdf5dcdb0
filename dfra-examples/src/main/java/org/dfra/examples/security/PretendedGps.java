package org.dfra.examples.security;

import java.io.IOException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.time.Instant;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicInteger;
import net.jini.core.entry.Entry;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.export.Exporter;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.module.Identification;
import org.dfra.river.entry.ModuleEntry;
import org.dfra.river.proxy.sensor.GPSProxy;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.remote.sensor.RemoteGPSSensor;
import org.dfra.river.server.Exporters;

/**
 * A GPS receiver that says that it is another robot's, and counts who believes it. It is exported
 * with the identity of the thread that makes it.
 */
final class PretendedGps implements AutoCloseable {

  private static final long DEADLINE_MILLIS = 2_000;
  private static final long LEASE_MILLIS = 300_000;

  private final AtomicInteger calls = new AtomicInteger();
  private final UUID id = UUID.randomUUID();
  private final String robot;
  private final String name;
  private final Exporter exporter = Exporters.jeri(DemoEnvironment.ADDRESS, DEADLINE_MILLIS);
  private final RemoteGPSSensor impl; // JERI holds it weakly
  private final GPSProxy proxy;

  /**
   * Exports it.
   *
   * @param robot whose it says that it is
   * @param name of the module that it says that it is
   */
  PretendedGps(String robot, String name) throws IOException {
    this.robot = robot;
    this.name = name;
    this.impl =
        (RemoteGPSSensor)
            Proxy.newProxyInstance(
                getClass().getClassLoader(),
                new Class<?>[] {RemoteGPSSensor.class},
                (self, method, arguments) -> answer(self, method, arguments));
    RemoteModule stub = (RemoteModule) exporter.export(impl);
    this.proxy =
        new GPSProxy(stub, id, new Identification(robot, name, "A receiver", "somebody else", "1"));
  }

  private Object answer(Object self, Method method, Object[] arguments) {
    return switch (method.getName()) {
      case "equals" -> self == arguments[0];
      case "hashCode" -> System.identityHashCode(self);
      case "toString" -> "a pretended receiver";
      default -> {
        calls.incrementAndGet();
        throw new IllegalStateException("a pretended receiver was called at " + Instant.now());
      }
    };
  }

  /** Registers it as the real one would be. */
  void register(ServiceRegistrar registrar) throws IOException {
    ModuleEntry entry = new ModuleEntry();
    entry.robot = robot;
    entry.name = name;
    register(registrar, entry);
  }

  /** Registers it with other entries, or none. */
  void register(ServiceRegistrar registrar, Entry... entries) throws IOException {
    registrar.register(new ServiceItem(serviceId(), proxy, entries), LEASE_MILLIS);
  }

  /** Its ID in lookup services. */
  ServiceID serviceId() {
    return new ServiceID(id.getMostSignificantBits(), id.getLeastSignificantBits());
  }

  /** How often it was called. */
  int calls() {
    return calls.get();
  }

  @Override
  public void close() {
    boolean unused = exporter.unexport(true);
  }
}
