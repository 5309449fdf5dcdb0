package org.dfra.river.transport;

import java.io.IOException;
import java.util.NoSuchElementException;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.io.UnsupportedConstraintException;
import net.jini.jeri.OutboundRequest;
import net.jini.jeri.OutboundRequestIterator;
import org.jspecify.annotations.Nullable;

/**
 * The attempts of one call: on a connection that was used before, and if the server had closed that
 * without executing the call, once more on a new one. Used by one thread.
 */
final class RequestIterator implements OutboundRequestIterator {

  private final ClientConnections connections;
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
      return new RequestIterator(connections, TransportConstraints.check(constraints));
    } catch (UnsupportedConstraintException e) {
      return new Refusal(e);
    }
  }

  private RequestIterator(ClientConnections connections, InvocationConstraints unfulfilled) {
    this.connections = connections;
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
      used = new OutboundCall(idle, connections, unfulfilled);
      return used;
    }
    return new OutboundCall(connections.open(), connections, unfulfilled);
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
