package java.rmi.activation;

import java.io.IOException;
import java.io.Serializable;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.rmi.server.RMIClientSocketFactory;
import java.rmi.server.RMIServerSocketFactory;

/**
 * Sockets that never leave the host: a group's instantiator is for its own host's daemon alone.
 *
 * <p>The client's half ignores the host written in the stub, which JRMP takes from the host's name
 * and which need not be a loopback address.
 */
final class LoopbackSocketFactory
    implements RMIClientSocketFactory, RMIServerSocketFactory, Serializable {

  private static final long serialVersionUID = 1L;

  /** As {@link ServerSocket} has it when nothing is said: waiting connections. */
  private static final int BACKLOG = 50;

  @Override
  public Socket createSocket(String host, int port) throws IOException {
    return new Socket(InetAddress.getLoopbackAddress(), port);
  }

  @Override
  public ServerSocket createServerSocket(int port) throws IOException {
    return new ServerSocket(port, BACKLOG, InetAddress.getLoopbackAddress());
  }

  /** All are alike, so that JRMP shares their ports and connections. */
  @Override
  public boolean equals(Object other) {
    return other instanceof LoopbackSocketFactory;
  }

  @Override
  public int hashCode() {
    return LoopbackSocketFactory.class.hashCode();
  }
}
