package org.dfra.river.callback;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.rmi.server.RemoteServer;
import java.rmi.server.ServerNotActiveException;
import net.jini.export.ServerContext;
import net.jini.io.context.ClientHost;

/**
 * Where a client is, as the connection tells that its call came by.
 *
 * @param host its address; {@link #UNKNOWN} where the transport does not tell
 * @param isOwn whether it is on this computer, which is trusted with larger bounds
 */
public record ClientAddress(String host, boolean isOwn) {

  /** Of all clients whose address is not known; they share what one client has. */
  public static final String UNKNOWN = "an unknown address";

  private static final String LOOPBACK = "127.0.0.1";
  private static final String LOOPBACK_6 = "0:0:0:0:0:0:0:1";

  /**
   * Where the call under way on this thread came from. A caller in this virtual machine is on this
   * computer.
   *
   * @param server address or name that this server's proxies carry: a call from there is this
   *     computer's own
   */
  public static ClientAddress ofCall(String server) {
    try {
      return ServerContext.getServerContextElement(ClientHost.class) instanceof ClientHost client
          ? of(client.getClientHost().getHostAddress(), server)
          : new ClientAddress(UNKNOWN, false);
    } catch (ServerNotActiveException e) {
      return ofJrmpCall(server);
    }
  }

  private static ClientAddress ofJrmpCall(String server) {
    try {
      return of(RemoteServer.getClientHost(), server);
    } catch (ServerNotActiveException e) { // no remote call at all
      return new ClientAddress(LOOPBACK, true);
    }
  }

  /**
   * A client at an address.
   *
   * @param host its address
   * @param server address or name that this server's proxies carry
   */
  public static ClientAddress of(String host, String server) {
    return new ClientAddress(
        host, host.equals(LOOPBACK) || host.equals(LOOPBACK_6) || host.equals(address(server)));
  }

  private static String address(String server) {
    try {
      return InetAddress.getByName(server).getHostAddress();
    } catch (UnknownHostException e) { // then nobody connects from there
      return server;
    }
  }
}
