package org.dfra.river.callback;

import java.net.InetAddress;
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

  private static final ResolvedHosts HOSTS = ResolvedHosts.ofSystem();

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

  /** Looks nothing up: it runs while a call is dispatched, and often under a lock. */
  private static boolean isOwn(InetAddress address, String server) {
    if (OwnAddresses.alwaysContain(address)) {
      return true;
    }
    return address.isLoopbackAddress() // until the server's is known, the smaller bounds hold
        && HOSTS.of(server).map(own -> own.contain(address)).orElse(false);
  }
}
