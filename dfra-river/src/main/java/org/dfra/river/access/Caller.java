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
 * @param address the address it connected from, as this computer sees it; null where the transport
 *     does not say
 */
public record Caller(@Nullable InetAddress address) {

  /**
   * The client of a call that has this server context.
   *
   * @param context the context's elements
   */
  public static Caller in(Collection<?> context) {
    return new Caller(
        context.stream()
            .filter(ClientHost.class::isInstance)
            .map(element -> ((ClientHost) element).getClientHost())
            .findFirst()
            .orElse(null));
  }

  /**
   * The client at an address that was written down.
   *
   * @param host the address in digits; of null, and of a name, which is not looked up, the address
   *     is not known
   */
  public static Caller at(@Nullable String host) {
    if (host == null) {
      return new Caller(null);
    }
    try {
      return new Caller(AddressRange.of(host).network());
    } catch (IllegalArgumentException e) {
      return new Caller(null);
    }
  }

  /** The client of the remote call in progress on this thread; empty where there is none. */
  public static Optional<Caller> current() {
    try {
      return Optional.of(in(ServerContext.getServerContext()));
    } catch (ServerNotActiveException e) {
      return overJrmp();
    }
  }

  private static Optional<Caller> overJrmp() {
    try {
      return Optional.of(new Caller(InetAddress.getByName(RemoteServer.getClientHost())));
    } catch (ServerNotActiveException e) {
      return Optional.empty();
    } catch (UnknownHostException e) { // it is called by somebody, but not by an address
      return Optional.of(new Caller(null));
    }
  }

  /** Its address in digits, or what stands for it. */
  @Override
  public String toString() {
    return address == null ? "an unknown address" : address.getHostAddress();
  }
}
