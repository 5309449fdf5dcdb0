package org.dfra.river.transport;

import java.io.Serializable;
import java.net.InetAddress;
import java.util.Objects;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.jeri.OutboundRequestIterator;
import org.dfra.river.access.NumericAddress;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.CurrentIdentity;
import org.jspecify.annotations.Nullable;

/**
 * An endpoint that is called from one of several addresses of this computer, always by TCP.
 *
 * @param host address or name that the server listens on
 * @param port TCP port of the server
 * @param source the numeric address to connect from
 * @param group calls of equal groups share connections
 */
public record SourceBoundEndpoint(String host, int port, String source, int group)
    implements AbortableEndpoint, Serializable {

  private static final long serialVersionUID = 1L;

  /**
   * Checks them.
   *
   * @throws IllegalArgumentException if the source is no numeric address, or the port none
   */
  public SourceBoundEndpoint {
    Objects.requireNonNull(host, "host");
    InetAddress unused = numeric(source);
    TransportEndpoint checked = new TransportEndpoint(host, port);
  }

  private static InetAddress numeric(String source) {
    @Nullable InetAddress address = NumericAddress.parse(source);
    if (address == null) {
      throw new IllegalArgumentException("the source " + source + " is no numeric address");
    }
    return address;
  }

  private ClientConnections connections() {
    return ClientConnections.to(new TransportEndpoint(host, port), numeric(source), group);
  }

  /** That of the thread that calls. */
  @Override
  public @Nullable ChannelIdentity identity() {
    return CurrentIdentity.get();
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
