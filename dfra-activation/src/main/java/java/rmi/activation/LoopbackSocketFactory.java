package java.rmi.activation;

import java.io.IOException;
import java.io.Serializable;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.rmi.server.RMIClientSocketFactory;
import java.rmi.server.RMIServerSocketFactory;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;

/**
 * Sockets that never leave the host: only the daemon of the same host calls a group's instantiator.
 *
 * <p>The client side ignores the host in the stub, which JRMP takes from the host's name and which
 * need not be a loopback address.
 */
final class LoopbackSocketFactory
    implements RMIClientSocketFactory, RMIServerSocketFactory, Serializable {

  private static final long serialVersionUID = 1L;

  /** The default backlog of {@link ServerSocket}: pending connections. */
  private static final int BACKLOG = 50;

  private final transient List<ServerSocket> opened = new CopyOnWriteArrayList<>();

  @Override
  public Socket createSocket(String host, int port) throws IOException {
    return new Socket(InetAddress.getLoopbackAddress(), port);
  }

  @Override
  public ServerSocket createServerSocket(int port) throws IOException {
    ServerSocket socket = new ServerSocket(port, BACKLOG, InetAddress.getLoopbackAddress());
    opened.add(socket);
    return socket;
  }

  /** Ends to listen on what this instance has opened. JRMP then ends the threads that accept. */
  void close() {
    for (ServerSocket each : opened) {
      try {
        each.close();
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  }

  /** All instances are equal, so that JRMP shares their ports and connections. */
  @Override
  public boolean equals(Object other) {
    return other instanceof LoopbackSocketFactory;
  }

  @Override
  public int hashCode() {
    return LoopbackSocketFactory.class.hashCode();
  }
}
