package org.dfra.secure;

import java.lang.reflect.Proxy;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicInteger;
import net.jini.core.entry.Entry;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.jeri.BasicJeriExporter;
import org.dfra.example.thermometer.RemoteThermometer;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.module.Identification;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.remote.RemoteModule;

/**
 * A thermometer that says that it is another robot's, exported and registered with the identity of
 * the thread that makes it.
 */
final class PretendedThermometer implements AutoCloseable {

  private static final long LEASE_MILLIS = 60_000;

  private final AtomicInteger calls = new AtomicInteger();
  private final UUID id = UUID.randomUUID();
  private final BasicJeriExporter exporter =
      new BasicJeriExporter(
          Endpoints.tcp(SecureTeam.HOST, 0), new DeadlineILFactory(), false, true);

  /** JERI holds it weakly. */
  private final RemoteThermometer impl =
      (RemoteThermometer)
          Proxy.newProxyInstance(
              getClass().getClassLoader(),
              new Class<?>[] {RemoteThermometer.class},
              (self, method, arguments) -> {
                if (method.getDeclaringClass() == Object.class) {
                  return method.getName().equals("equals")
                      ? (Object) (self == arguments[0])
                      : method.getName().equals("hashCode")
                          ? (Object) System.identityHashCode(self)
                          : "a pretended thermometer";
                }
                calls.incrementAndGet();
                return method.getReturnType() == double.class ? (Object) (-1.0) : null;
              });

  /**
   * Registers it.
   *
   * @param robot whose it says that it is
   */
  PretendedThermometer(String robot, String name, int registrar) throws Exception {
    RemoteModule stub = (RemoteModule) exporter.export(impl);
    ThermometerProxy proxy =
        new ThermometerProxy(
            stub, id, new Identification(robot, name, "A thermometer", "somebody", "1"));
    MemberCalls.registrar(registrar)
        .register(
            new ServiceItem(
                new ServiceID(id.getMostSignificantBits(), id.getLeastSignificantBits()),
                proxy,
                new Entry[0]),
            LEASE_MILLIS);
  }

  ServiceID id() {
    return new ServiceID(id.getMostSignificantBits(), id.getLeastSignificantBits());
  }

  int calls() {
    return calls.get();
  }

  @Override
  public void close() {
    boolean unused = exporter.unexport(true);
  }
}
