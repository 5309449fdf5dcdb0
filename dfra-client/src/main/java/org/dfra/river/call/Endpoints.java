package org.dfra.river.call;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.UnknownHostException;
import javax.net.ServerSocketFactory;
import net.jini.jeri.Endpoint;
import net.jini.jeri.ServerEndpoint;
import net.jini.jeri.tcp.TcpEndpoint;
import net.jini.jeri.tcp.TcpServerEndpoint;
import org.dfra.river.transport.TransportEndpoint;
import org.dfra.river.transport.TransportServerEndpoint;
import org.jspecify.annotations.Nullable;

/**
 * JERI endpoints that listen on one address only: the one that their proxies carry.
 *
 * <p>{@link #tcp} is the default everywhere. Where clients without DFRA's transport call, a Jini
 * configuration names {@link #river} instead: River's own transport, whose endpoints otherwise
 * listen on every interface, including those that a robot's operator did not configure.
 */
public final class Endpoints {

  private Endpoints() {}

  /**
   * An endpoint to export on.
   *
   * @param host address or name of this machine; proxies carry it, and only it is listened on
   * @param port TCP port, or 0 for one that the system chooses
   */
  public static ServerEndpoint tcp(String host, int port) {
    return new TransportServerEndpoint(host, port);
  }

  /**
   * As {@link #tcp}, with a Unix-domain socket beside it for clients on the same computer. Chosen
   * by a Jini configuration: by default they use TCP too, which is about as fast.
   *
   * @param host address or name of this machine; proxies carry it, and only it is listened on
   * @param port TCP port, or 0 for one that the system chooses
   */
  public static ServerEndpoint withLocalSocket(String host, int port) {
    return TransportServerEndpoint.withLocalSocket(host, port);
  }

  /**
   * The client's side of such an endpoint.
   *
   * @param host address or name that it listens on
   * @param port its TCP port
   */
  public static Endpoint tcpClient(String host, int port) {
    return new TransportEndpoint(host, port);
  }

  /**
   * An endpoint of River's transport to export on. Its clients close broken connections.
   *
   * @param host address or name of this machine; proxies carry it, and only it is listened on
   * @param port TCP port, or 0 for one that the system chooses
   * @throws IllegalArgumentException if the host is unknown
   * @throws IllegalStateException if this process has joined a team
   */
  public static ServerEndpoint river(String host, int port) {
    EncryptedExport.require("River's own transport");
    return TcpServerEndpoint.getInstance(host, port, new PeerSockets(), serverSocketFactory(host));
  }

  /** The client's side of an endpoint of River's transport. */
  static Endpoint riverClient(String host, int port) {
    return TcpEndpoint.getInstance(host, port, new PeerSockets());
  }

  /**
   * A factory of server sockets that listen on one address.
   *
   * @throws IllegalArgumentException if the host is unknown
   */
  public static ServerSocketFactory serverSocketFactory(String host) {
    try {
      return new Bound(InetAddress.getByName(host));
    } catch (UnknownHostException e) {
      throw new IllegalArgumentException(
          "host " + host + " is not known; name an address of this machine", e);
    }
  }

  private static final class Bound extends ServerSocketFactory {

    private final InetAddress address;

    Bound(InetAddress address) {
      this.address = address;
    }

    @Override
    public ServerSocket createServerSocket() throws IOException {
      return createServerSocket(0);
    }

    @Override
    public ServerSocket createServerSocket(int port) throws IOException {
      return createServerSocket(port, 0);
    }

    @Override
    public ServerSocket createServerSocket(int port, int backlog) throws IOException {
      return createServerSocket(port, backlog, address);
    }

    @Override
    public ServerSocket createServerSocket(int port, int backlog, InetAddress ifAddress)
        throws IOException {
      return new ServerSocket(port, backlog, ifAddress);
    }

    @Override
    public boolean equals(@Nullable Object other) {
      return other instanceof Bound bound && bound.address.equals(address);
    }

    @Override
    public int hashCode() {
      return address.hashCode();
    }
  }
}
