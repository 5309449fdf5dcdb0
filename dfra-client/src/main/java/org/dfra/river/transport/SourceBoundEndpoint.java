package org.dfra.river.transport;

import java.io.Serializable;
import java.net.InetAddress;
import java.util.Objects;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.jeri.OutboundRequestIterator;
import org.dfra.river.access.NumericAddress;
import org.jspecify.annotations.Nullable;

/**
 * An endpoint that is called from one of several addresses of this computer, always by TCP.
 *
 * @param server the server's endpoint
 * @param source the numeric address to connect from
 * @param group calls of equal groups share connections
 */
public record SourceBoundEndpoint(TransportEndpoint server, String source, int group)
    implements AbortableEndpoint, Serializable {

  private static final long serialVersionUID = 1L;

  /**
   * Checks them.
   *
   * @throws IllegalArgumentException if the source is no numeric address
   */
  public SourceBoundEndpoint {
    Objects.requireNonNull(server, "server");
    InetAddress unused = numeric(source);
  }

  private static InetAddress numeric(String source) {
    @Nullable InetAddress address = NumericAddress.parse(source);
    if (address == null) {
      throw new IllegalArgumentException("the source " + source + " is no numeric address");
    }
    return address;
  }

  private ClientConnections connections() {
    return ClientConnections.to(server, numeric(source), group);
  }

  @Override
  public String host() {
    return server.host();
  }

  @Override
  public int port() {
    return server.port();
  }

  @Override
  public void closeIdleConnections() {
    connections().closeIdle();
  }

  @Override
  public OutboundRequestIterator newRequest(InvocationConstraints constraints) {
    return RequestIterator.of(connections(), constraints);
  }
}
