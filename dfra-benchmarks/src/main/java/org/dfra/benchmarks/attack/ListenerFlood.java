package org.dfra.benchmarks.attack;

import java.lang.reflect.Proxy;
import java.net.InetAddress;
import java.net.ServerSocket;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicInvocationHandler;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.tcp.TcpEndpoint;
import org.dfra.event.DeliveryPolicy;
import org.dfra.river.remote.RemoteModuleListener;
import org.dfra.river.remote.effector.RemoteDriveEffector;
import org.jspecify.annotations.Nullable;

/**
 * Registers a thousand listeners at the drive. Their host accepts connections and never answers;
 * they use JERI's own handler, which has no timeout.
 */
final class ListenerFlood extends AttackTask {

  private static final int LISTENERS = 1_000;
  private static final int EVENTS = 10; // memory kept for each listener
  private static final int BACKLOG = 1_024;
  private static final long FULL_MILLIS = 100;

  private @Nullable ServerSocket silent;
  private int registered;

  /** Called by {@code TaskMain} by reflection. */
  public ListenerFlood() {}

  @Override
  protected void prepare(Target target) throws Exception {
    silent = new ServerSocket(0, BACKLOG, InetAddress.getByName(target.source()));
  }

  @Override
  protected void attack(Target target) throws Exception {
    RemoteDriveEffector drive = target.remoteDrive();
    while (!isStopping()) {
      if (registered >= LISTENERS) {
        pause(FULL_MILLIS);
        continue;
      }
      RemoteModuleListener listener = listener(target);
      if (attempt(() -> drive.subscribe(listener, DeliveryPolicy.keepLast(EVENTS))) != null) {
        registered++;
      }
    }
  }

  private RemoteModuleListener listener(Target target) {
    ServerSocket server = silent;
    if (server == null) {
      throw new IllegalStateException("not prepared");
    }
    TcpEndpoint endpoint = TcpEndpoint.getInstance(target.source(), server.getLocalPort());
    return (RemoteModuleListener)
        Proxy.newProxyInstance(
            ListenerFlood.class.getClassLoader(),
            new Class<?>[] {RemoteModuleListener.class},
            new BasicInvocationHandler(
                new BasicObjectEndpoint(endpoint, UuidFactory.generate(), false), null));
  }
}
