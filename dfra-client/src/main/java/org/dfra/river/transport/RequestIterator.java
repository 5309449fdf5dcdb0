package org.dfra.river.transport;

import java.io.IOException;
import java.util.NoSuchElementException;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.io.UnsupportedConstraintException;
import net.jini.jeri.OutboundRequest;
import net.jini.jeri.OutboundRequestIterator;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.ChannelPeer;
import org.jspecify.annotations.Nullable;

/**
 * The attempts of one call: on a connection that was used before, and if the server had closed that
 * without executing the call, once more on a new one. Used by one thread.
 */
final class RequestIterator implements OutboundRequestIterator {

  private final ClientConnections connections;
  private final InvocationConstraints constraints;
  private final InvocationConstraints unfulfilled;
  private @Nullable OutboundCall used;
  private boolean isOver;

  /**
   * The attempts of a call.
   *
   * @param connections to its server
   * @param constraints of the call
   */
  static OutboundRequestIterator of(
      ClientConnections connections, InvocationConstraints constraints) {
    try {
      @Nullable ChannelIdentity identity = connections.identity();
      InvocationConstraints unfulfilled =
          identity == null
              ? TransportConstraints.checkPlain(constraints)
              : TransportConstraints.checkEncrypted(
                  constraints, identity.subject().getPrincipals(), null);
      return new RequestIterator(connections, constraints, unfulfilled);
    } catch (UnsupportedConstraintException e) {
      return new Refusal(e);
    }
  }

  private RequestIterator(
      ClientConnections connections,
      InvocationConstraints constraints,
      InvocationConstraints unfulfilled) {
    this.connections = connections;
    this.constraints = constraints;
    this.unfulfilled = unfulfilled;
  }

  @Override
  public boolean hasNext() {
    return !isOver || (used != null && !used.getDeliveryStatus());
  }

  @Override
  public OutboundRequest next() throws IOException {
    if (!hasNext()) {
      throw new NoSuchElementException("this call may not be repeated");
    }
    @Nullable ClientConnection idle = isOver ? null : connections.takeIdle();
    isOver = true;
    used = null;
    if (idle != null) {
      used = call(idle);
      return used;
    }
    return call(connections.open());
  }

  private OutboundCall call(ClientConnection connection) throws UnsupportedConstraintException {
    @Nullable ChannelIdentity identity = connections.identity();
    @Nullable ChannelPeer server = connection.link().partner();
    if (identity != null && server != null && !constraints.isEmpty()) {
      checkServer(connection, identity, server);
    }
    return new OutboundCall(connection, connections, unfulfilled);
  }

  /** Only a connection shows who the server is. */
  private void checkServer(
      ClientConnection connection, ChannelIdentity identity, ChannelPeer server)
      throws UnsupportedConstraintException {
    boolean isMet = false;
    try {
      InvocationConstraints unused =
          TransportConstraints.checkEncrypted(
              constraints, identity.subject().getPrincipals(), server.subject().getPrincipals());
      isMet = true;
    } finally {
      if (!isMet) {
        connections.giveBack(connection); // others may call this server
      }
    }
  }

  /** A call whose constraints cannot be met. */
  private static final class Refusal implements OutboundRequestIterator {

    private final UnsupportedConstraintException reason;
    private boolean isOver;

    Refusal(UnsupportedConstraintException reason) {
      this.reason = reason;
    }

    @Override
    public boolean hasNext() {
      return !isOver;
    }

    @Override
    public OutboundRequest next() throws IOException {
      isOver = true;
      throw reason;
    }
  }
}
