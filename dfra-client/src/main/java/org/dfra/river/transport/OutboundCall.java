package org.dfra.river.transport;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.ConnectException;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.util.Collection;
import java.util.Objects;
import javax.net.ssl.SSLHandshakeException;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.jeri.OutboundRequest;
import org.dfra.river.identity.ChannelPeer;
import org.jspecify.annotations.Nullable;

/**
 * A request and its response on one connection. Used by the caller's thread; any thread may abort
 * it.
 */
final class OutboundCall implements OutboundRequest, MessageOutput.Sender, MessageInput.Source {

  private final ClientConnection connection;
  private final ClientConnections owner;
  private final InvocationConstraints unfulfilled;
  private final MessageOutput request;
  private final MessageInput response;

  private volatile boolean delivered;

  @GuardedBy("this")
  private boolean ended; // the connection is no longer this call's

  OutboundCall(
      ClientConnection connection, ClientConnections owner, InvocationConstraints unfulfilled) {
    this.connection = connection;
    this.owner = owner;
    this.unfulfilled = unfulfilled;
    this.request = new MessageOutput(connection.output(), this);
    this.response = new MessageInput(connection.input(), this);
    TransportTraffic.countCallSent();
  }

  /** Adds who the server is, if it has proved that. */
  @Override
  @SuppressWarnings({"rawtypes", "unchecked"}) // as River declares it
  public void populateContext(Collection context) {
    Objects.requireNonNull(context, "context");
    @Nullable ChannelPeer server = connection.link().partner();
    if (server != null) {
      context.add(server);
    }
  }

  @Override
  public InvocationConstraints getUnfulfilledConstraints() {
    return unfulfilled;
  }

  @Override
  public OutputStream getRequestOutputStream() {
    return request;
  }

  @Override
  public InputStream getResponseInputStream() {
    return response;
  }

  @Override
  public void send(ByteBuffer block, boolean isEnd) throws IOException {
    boolean before = delivered;
    delivered = true; // before the first byte may leave
    try {
      connection.link().write(block);
    } catch (ClosedChannelException e) { // aborted or interrupted, maybe after bytes had left
      throw e;
    } catch (IOException e) { // the server had closed the connection
      delivered = before || block.position() > 0;
      if (delivered && hasRefusal()) {
        throw refused();
      }
      throw e;
    }
  }

  /** Whether the server has announced, while the request was sent, that it does not execute it. */
  private boolean hasRefusal() throws ServerNotAcceptedException {
    ByteBuffer input = connection.input().clear();
    try {
      connection.link().setBlocking(false);
      int unused = connection.link().read(input);
      input.flip();
      return input.remaining() >= Block.HEADER_BYTES
          && Block.decode(input.getInt(0)).kind() == Block.Kind.CLOSING;
    } catch (SSLHandshakeException e) {
      if (connection.isNew()) {
        throw notAccepted(e);
      }
      return false;
    } catch (IOException e) {
      return false;
    }
  }

  @Override
  public void receive(ByteBuffer buffer) throws IOException {
    int count;
    try {
      count = connection.link().read(buffer);
    } catch (SSLHandshakeException e) {
      throw connection.isNew() ? notAccepted(e) : e;
    }
    if (count < 0) {
      throw MessageInput.ended();
    }
  }

  /**
   * The server checks a client's certificate when the client's handshake is over, and reads no
   * request before that.
   */
  private ServerNotAcceptedException notAccepted(SSLHandshakeException alert) {
    delivered = false;
    return owner.notAccepted(alert);
  }

  @Override
  public IOException refused() {
    delivered = false;
    connection.forgetSession();
    return new ConnectException("the server closed the connection before it executed the call");
  }

  /** Makes the connection available to other calls, if the response was read. */
  @Override
  public void closed() {
    synchronized (this) {
      if (ended) {
        return;
      }
      ended = true;
    }
    if (request.isComplete() && response.skipReceived() && !connection.input().hasRemaining()) {
      owner.giveBack(connection);
    } else {
      connection.close();
    }
  }

  /**
   * {@inheritDoc} For this transport: whether bytes of the request may have been sent, and the
   * server did not say that it had not executed it. Final after {@link #abort}.
   */
  @Override
  public boolean getDeliveryStatus() {
    return delivered;
  }

  @Override
  public void abort() {
    synchronized (this) {
      if (ended) {
        return;
      }
      ended = true;
    }
    connection.close();
  }
}
