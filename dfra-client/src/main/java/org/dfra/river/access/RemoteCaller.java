package org.dfra.river.access;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.rmi.server.RemoteServer;
import java.rmi.server.ServerNotActiveException;
import java.util.Collection;
import java.util.Optional;
import net.jini.export.ServerContext;
import net.jini.io.context.ClientHost;
import org.jspecify.annotations.Nullable;

/**
 * The client of a remote call.
 *
 * @param address the address it connected from, as this computer sees it; null if the transport
 *     does not report it
 */
public record RemoteCaller(@Nullable InetAddress address) {

  /**
   * The client of a call with this server context.
   *
   * @param context the context's elements
   */
  public static RemoteCaller fromContext(Collection<?> context) {
    return new RemoteCaller(
        context.stream()
            .filter(ClientHost.class::isInstance)
            .map(element -> ((ClientHost) element).getClientHost())
            .findFirst()
            .orElse(null));
  }

  /**
   * The client at an address given as text.
   *
   * @param host the numeric address; for null, and for a name, which is not resolved, the address
   *     is unknown
   */
  public static RemoteCaller fromHost(@Nullable String host) {
    if (host == null) {
      return new RemoteCaller(null);
    }
    try {
      return new RemoteCaller(AddressRange.of(host).network());
    } catch (IllegalArgumentException e) {
      return new RemoteCaller(null);
    }
  }

  /** The client of the remote call in progress on this thread; empty if there is none. */
  public static Optional<RemoteCaller> current() {
    try {
      return Optional.of(fromContext(ServerContext.getServerContext()));
    } catch (ServerNotActiveException e) {
      return overJrmp();
    }
  }

  private static Optional<RemoteCaller> overJrmp() {
    try {
      return Optional.of(new RemoteCaller(InetAddress.getByName(RemoteServer.getClientHost())));
    } catch (ServerNotActiveException e) {
      return Optional.empty();
    } catch (UnknownHostException e) { // a remote call, but without an address
      return Optional.of(new RemoteCaller(null));
    }
  }

  /** Its numeric address, or a substitute text. */
  @Override
  public String toString() {
    return address == null ? "an unknown address" : address.getHostAddress();
  }
}
