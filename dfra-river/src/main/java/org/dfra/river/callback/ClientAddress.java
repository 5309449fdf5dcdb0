package org.dfra.river.callback;

import java.net.InetAddress;
import org.dfra.river.access.OwnAddresses;
import org.dfra.river.access.RemoteCaller;
import org.jspecify.annotations.Nullable;

/**
 * Where a client is, as the connection that its call came by shows.
 *
 * @param host its address, or what {@link RemoteCaller} says where that is not known; all clients
 *     of unknown address share what one client has
 * @param isLocal whether it is on this computer, as {@link OwnAddresses} has it; this computer is
 *     trusted with larger bounds
 */
public record ClientAddress(String host, boolean isLocal) {

  private static final String LOOPBACK = "127.0.0.1";

  private static final ResolvedHosts HOSTS = ResolvedHosts.ofSystem();

  /**
   * Where the call under way on this thread came from. A caller in this virtual machine is on this
   * computer.
   *
   * @param serverHost address or name that this server's proxies carry
   */
  public static ClientAddress ofCurrentCall(String serverHost) {
    return RemoteCaller.current()
        .map(caller -> of(caller, serverHost))
        .orElseGet(() -> new ClientAddress(LOOPBACK, true));
  }

  /**
   * A client at an address.
   *
   * @param host its address in digits; that of a name is not known
   * @param serverHost address or name that this server's proxies carry
   */
  public static ClientAddress of(String host, String serverHost) {
    return of(RemoteCaller.fromHost(host), serverHost);
  }

  private static ClientAddress of(RemoteCaller caller, String serverHost) {
    @Nullable InetAddress address = caller.address();
    return new ClientAddress(caller.toString(), address != null && isLocal(address, serverHost));
  }

  /** Looks nothing up: it runs while a call is dispatched, and often under a lock. */
  private static boolean isLocal(InetAddress address, String server) {
    if (OwnAddresses.isAlwaysLocal(address)) {
      return true;
    }
    return address.isLoopbackAddress() // until the server's is known, the smaller bounds hold
        && HOSTS.addressesOf(server).map(own -> own.contains(address)).orElse(false);
  }
}
