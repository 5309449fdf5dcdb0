package org.dfra.river.callback;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.dfra.river.access.Caller;
import org.dfra.river.access.OwnAddresses;
import org.jspecify.annotations.Nullable;

/**
 * Where a client is, as the connection that its call came by shows.
 *
 * @param host its address, or what {@link Caller} says where that is not known; all clients of
 *     unknown address share what one client has
 * @param isOwn whether it is on this computer, as {@link OwnAddresses} has it; this computer is
 *     trusted with larger bounds
 */
public record ClientAddress(String host, boolean isOwn) {

  private static final String LOOPBACK = "127.0.0.1";

  /** By the server's host: this virtual machine serves at a few. */
  private static final Map<String, OwnAddresses> OWN = new ConcurrentHashMap<>();

  /**
   * Where the call under way on this thread came from. A caller in this virtual machine is on this
   * computer.
   *
   * @param server address or name that this server's proxies carry
   */
  public static ClientAddress ofCall(String server) {
    return Caller.current()
        .map(caller -> of(caller, server))
        .orElseGet(() -> new ClientAddress(LOOPBACK, true));
  }

  /**
   * A client at an address.
   *
   * @param host its address in digits; that of a name is not known
   * @param server address or name that this server's proxies carry
   */
  public static ClientAddress of(String host, String server) {
    return of(Caller.at(host), server);
  }

  private static ClientAddress of(Caller caller, String server) {
    @Nullable InetAddress address = caller.address();
    return new ClientAddress(caller.toString(), address != null && isOwn(address, server));
  }

  private static boolean isOwn(InetAddress address, String server) {
    @Nullable OwnAddresses own = OWN.get(server);
    if (own == null) {
      try {
        own = OwnAddresses.exportedAt(server);
      } catch (UnknownHostException e) { // until it is known, the smaller bounds hold
        return false;
      }
      OWN.put(server, own);
    }
    return own.contain(address);
  }
}
