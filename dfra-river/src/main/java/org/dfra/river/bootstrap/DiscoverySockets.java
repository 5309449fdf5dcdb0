package org.dfra.river.bootstrap;

import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.ServerSocket;
import javax.net.ServerSocketFactory;
import org.dfra.river.call.Endpoints;

/**
 * Where a robot's registrar listens for unicast discovery: at one address only, and where its port
 * is taken, it says so. Named in {@code registrar.config}.
 */
public final class DiscoverySockets extends ServerSocketFactory {

  private final String host;
  private final ServerSocketFactory sockets;

  /**
   * @param host address or name of this machine
   * @throws IllegalArgumentException if the host is not known
   */
  public DiscoverySockets(String host) {
    this.host = host;
    this.sockets = Endpoints.sockets(host);
  }

  @Override
  public ServerSocket createServerSocket(int port) throws IOException {
    try {
      return sockets.createServerSocket(port);
    } catch (BindException e) {
      throw taken(port, e);
    }
  }

  @Override
  public ServerSocket createServerSocket(int port, int backlog) throws IOException {
    try {
      return sockets.createServerSocket(port, backlog);
    } catch (BindException e) {
      throw taken(port, e);
    }
  }

  @Override
  public ServerSocket createServerSocket(int port, int backlog, InetAddress address)
      throws IOException {
    try {
      return sockets.createServerSocket(port, backlog, address);
    } catch (BindException e) {
      throw taken(port, e);
    }
  }

  private BindException taken(int port, BindException cause) {
    BindException told =
        new BindException(
            "port "
                + port
                + " of "
                + host
                + " cannot be listened on ("
                + cause.getMessage()
                + "); end what listens there, or give the registrar another port");
    told.initCause(cause);
    return told;
  }
}
