package org.dfra.river.callback;

import java.net.InetAddress;
import org.dfra.river.access.OwnAddresses;
import org.dfra.river.access.RemoteCaller;
import org.jspecify.annotations.Nullable;

/**
 * The address of a client, from the connection of its call.
 *
 * @param host its address, or the text of {@link RemoteCaller} if that is unknown; all clients of
 *     unknown address share the limits of one client
 * @param isLocal whether it is on this computer, according to {@link OwnAddresses}; this computer
 *     has higher limits
 */
public record ClientAddress(String host, boolean isLocal) {

  private static final String LOOPBACK = "127.0.0.1";

  private static final AsyncHostResolver HOSTS = AsyncHostResolver.ofSystem();

  /**
   * The client of the call that runs on this thread. A caller in this virtual machine is on this
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
   * @param host its numeric address; a name is not resolved
   * @param serverHost address or name that this server's proxies carry
   */
  public static ClientAddress of(String host, String serverHost) {
    return of(RemoteCaller.fromHost(host), serverHost);
  }

  private static ClientAddress of(RemoteCaller caller, String serverHost) {
    @Nullable InetAddress address = caller.address();
    return new ClientAddress(caller.toString(), address != null && isLocal(address, serverHost));
  }

  /** Does no name look-up: it runs while a call is dispatched, and often under a lock. */
  private static boolean isLocal(InetAddress address, String server) {
    if (OwnAddresses.isAlwaysLocal(address)) {
      return true;
    }
    // until the server's addresses are known, the lower limits apply
    return address.isLoopbackAddress()
        && HOSTS.addressesOf(server).map(own -> own.contains(address)).orElse(false);
  }
}
