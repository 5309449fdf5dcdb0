package org.dfra.attack.stop;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.rmi.RemoteException;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Arrays;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicInteger;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.entry.Entry;
import net.jini.core.lease.Lease;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceMatches;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import net.jini.export.Exporter;
import net.jini.jeri.BasicJeriExporter;
import org.dfra.attack.kit.SilentPeer;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.module.Identification;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.entry.ModuleEntry;
import org.dfra.river.proxy.effector.DriveProxy;
import org.dfra.river.remote.effector.RemoteDriveEffector;

/** Proxies of drives that answer every stop with "stopped", in the registrar of a robot. */
final class FalseDrives implements AutoCloseable {

  private static final long LEASE_MILLIS = 60_000;

  private final AtomicInteger orders = new AtomicInteger();
  private final ServiceRegistrar registrar;
  private final ServiceItem real;
  private final Exporter exporter =
      new BasicJeriExporter(Endpoints.tcp("127.0.0.1", 0), new DeadlineILFactory(), false, true);
  private final RemoteDriveEffector server; // JERI holds it weakly
  private final RemoteDriveEffector proxy;

  /**
   * Finds the drive that they resemble.
   *
   * @param locator of the registrar, {@code jini://host:port}
   */
  FalseDrives(String locator) throws Exception {
    registrar = new LookupLocator(locator).getRegistrar();
    ServiceMatches drives =
        registrar.lookup(new ServiceTemplate(null, new Class<?>[] {DriveEffector.class}, null), 1);
    real = drives.items[0];
    InvocationHandler says =
        (self, method, args) ->
            switch (method.getName()) {
              case "emergencyStop", "emergencyStopState" -> {
                if (method.getName().equals("emergencyStop")) {
                  orders.incrementAndGet();
                }
                Instant now = Instant.now().truncatedTo(ChronoUnit.MILLIS);
                yield new EmergencyStopState(true, "a fake", now, true, null);
              }
              case "hashCode" -> System.identityHashCode(self);
              case "equals" -> self == args[0];
              case "toString" -> "a fake";
              default -> throw new RemoteException("a fake has no " + method.getName());
            };
    server =
        (RemoteDriveEffector)
            Proxy.newProxyInstance(
                getClass().getClassLoader(), new Class<?>[] {RemoteDriveEffector.class}, says);
    proxy = (RemoteDriveEffector) exporter.export(server);
  }

  private static Identification named(String robot, String name) {
    return new Identification(robot, name, "a drive", "nobody", "1.0");
  }

  /** Puts a fake in the place of the real drive, until that registers itself again. */
  void replace() throws RemoteException {
    ServiceID id = real.serviceID;
    UUID uuid = new UUID(id.getMostSignificantBits(), id.getLeastSignificantBits());
    DriveProxy fake = new DriveProxy(proxy, uuid, named("eta", "drive"));
    Object unused =
        registrar.register(new ServiceItem(id, fake, real.attributeSets), LEASE_MILLIS).getLease();
  }

  /** How many orders to stop the fakes have answered. */
  int orders() {
    return orders.get();
  }

  /** Registers a fake drive of a robot. */
  Lease add(String robot) throws RemoteException {
    return add(robot, proxy);
  }

  /** Registers a drive of a robot whose server never answers. */
  Lease addSilent(String robot, SilentPeer peer) throws RemoteException {
    return add(robot, peer.proxy(RemoteDriveEffector.class));
  }

  private Lease add(String robot, RemoteDriveEffector server) throws RemoteException {
    UUID uuid = UUID.randomUUID();
    ServiceID id = new ServiceID(uuid.getMostSignificantBits(), uuid.getLeastSignificantBits());
    DriveProxy fake = new DriveProxy(server, uuid, named(robot, "drive"));
    return registrar.register(new ServiceItem(id, fake, entries(robot)), LEASE_MILLIS).getLease();
  }

  /** The real drive's, but for the robot's name. */
  private Entry[] entries(String robot) {
    return Arrays.stream(real.attributeSets)
        .filter(ModuleEntry.class::isInstance)
        .map(ModuleEntry.class::cast)
        .map(each -> of(each, robot))
        .toArray(Entry[]::new);
  }

  private static ModuleEntry of(ModuleEntry real, String robot) {
    ModuleEntry entry = new ModuleEntry();
    entry.robot = robot;
    entry.name = real.name;
    entry.driver = real.driver;
    entry.host = real.host;
    entry.author = real.author;
    entry.version = real.version;
    entry.state = real.state;
    entry.created = real.created;
    entry.activated = real.activated;
    entry.clients = real.clients;
    return entry;
  }

  @Override
  public void close() {
    exporter.unexport(true);
  }
}
