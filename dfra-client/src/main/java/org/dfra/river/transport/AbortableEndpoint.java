package org.dfra.river.transport;

import net.jini.jeri.Endpoint;
import org.dfra.river.identity.ChannelIdentity;
import org.jspecify.annotations.Nullable;

/**
 * An endpoint whose requests never hold their caller longer than it wants: what may block, from
 * resolving the host to reading the response, ends when {@link CallInFlight#abandon} is called.
 */
public interface AbortableEndpoint extends Endpoint {

  /** The address or name of the server's host. */
  String host();

  /** The TCP port of the server. */
  int port();

  /**
   * Who its client is; null if its calls are not encrypted. What is received in answers keeps it.
   */
  @Nullable ChannelIdentity identity();

  /**
   * Closes the connections to this server that no call uses. The next call opens a new one. After a
   * call without a response: the peer may have been out of radio range, and TCP takes long to
   * resume an old connection.
   */
  void closeIdleConnections();
}
