package org.dfra.attack.kit;

import java.io.IOException;
import java.lang.reflect.Proxy;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.rmi.Remote;
import java.util.ArrayList;
import java.util.List;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicInvocationHandler;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.tcp.TcpEndpoint;

/**
 * An attacker's sockets that take connections and never answer, and stock proxies that lead there:
 * without a deadline, a socket factory or garbage collection.
 */
public final class SilentPeer implements AutoCloseable {

  /** Connections that the operating system takes for each, though nobody accepts them. */
  private static final int BACKLOG = 200;

  private final String host;
  private final List<ServerSocket> sockets = new ArrayList<>();
  private int next; // which socket the next proxy leads to

  /**
   * @param host the attacker's address
   * @param sockets how many sockets listen there, at least 1
   */
  public SilentPeer(String host, int sockets) throws IOException {
    this.host = host;
    for (int i = 0; i < sockets; i++) {
      this.sockets.add(new ServerSocket(0, BACKLOG, InetAddress.getByName(host)));
    }
  }

  /** A proxy for an object of its own, at the next of the sockets. */
  public <T extends Remote> T proxy(Class<T> type) {
    int port = sockets.get(next++ % sockets.size()).getLocalPort();
    return type.cast(
        Proxy.newProxyInstance(
            type.getClassLoader(),
            new Class<?>[] {type},
            new BasicInvocationHandler(
                new BasicObjectEndpoint(
                    TcpEndpoint.getInstance(host, port), UuidFactory.generate(), false),
                null)));
  }

  @Override
  public void close() throws IOException {
    for (ServerSocket each : sockets) {
      each.close();
    }
  }
}
