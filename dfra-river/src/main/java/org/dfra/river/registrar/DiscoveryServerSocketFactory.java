package org.dfra.river.registrar;

import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.UnknownHostException;
import javax.net.ServerSocketFactory;
import org.jspecify.annotations.Nullable;

/**
 * Creates the server socket for unicast discovery of a robot's registrar. It listens at one address
 * only and reports a port conflict. Clients that connect and send nothing are bounded, see {@link
 * DiscoveryServerSocket}. Named in {@code registrar.config}.
 */
public final class DiscoveryServerSocketFactory extends ServerSocketFactory {

  private final String host;
  private final InetAddress address;

  /**
   * @param host address or name of this machine
   * @throws IllegalArgumentException if the host is unknown
   */
  public DiscoveryServerSocketFactory(String host) {
    this.host = host;
    try {
      this.address = InetAddress.getByName(host);
    } catch (UnknownHostException e) {
      throw new IllegalArgumentException(
          "host " + host + " is not known; name an address of this machine", e);
    }
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
  public ServerSocket createServerSocket(int port, int backlog, @Nullable InetAddress at)
      throws IOException {
    try {
      return new DiscoveryServerSocket(port, backlog, at);
    } catch (BindException e) {
      throw taken(port, e);
    }
  }

  private BindException taken(int port, BindException cause) {
    BindException reported =
        new BindException(
            "port "
                + port
                + " of "
                + host
                + " cannot be listened on ("
                + cause.getMessage()
                + "); end what listens there, or give the registrar another port");
    reported.initCause(cause);
    return reported;
  }
}
