package org.dfra.river.access;

import net.jini.jeri.ServerCapabilities;
import net.jini.jeri.tcp.TcpServerEndpoint;
import org.jspecify.annotations.Nullable;

/** A server endpoint that listens on one host. */
public interface ListeningHost {

  /** The address or name that it listens on, and that its proxies carry. */
  String host();

  /**
   * The host that an endpoint listens on.
   *
   * @param capabilities the endpoint, as a dispatcher gets it
   * @return null if it is unknown
   */
  static @Nullable String of(ServerCapabilities capabilities) {
    if (capabilities instanceof ListeningHost listening) {
      return listening.host();
    }
    return capabilities instanceof TcpServerEndpoint tcp ? tcp.getHost() : null;
  }
}
